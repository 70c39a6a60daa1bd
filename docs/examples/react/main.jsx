import { useState } from "react";
import { createRoot } from "react-dom/client";
import "pasu-pot";

function Vase() {
  const [dints, setDints] = useState(5);
  const [link, setLink] = useState("");
  return (
    <>
      <h1>A vase in React</h1>
      <label>
        Dints <input type="number" value={dints} onChange={(event) => setDints(Number(event.target.value))} />
      </label>
      <pasu-pot src={`#1/bloor-wilson?n1=${dints}`} alt="A small vase" onload={(event) => setLink(event.detail.link)} />
      <output>{link}</output>
    </>
  );
}

createRoot(document.querySelector("#root")).render(<Vase />);
