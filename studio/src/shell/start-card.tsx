import { displayName } from '../display-name.ts'
import { START } from '../labels/project.ts'
import { Recent } from '../panels/keeping/recent.tsx'
import type { PanelModel } from '../panels/model.ts'
import { OpenButtons } from './open-buttons.tsx'

/** Card on the empty stage: opens files, recent work and the faces of the server. */
export function StartCard({ model }: { model: PanelModel }) {
  const { viewer, faces, actions } = model
  if (viewer.value || faces.value.length === 0) return null
  return (
    <section class="start-card" aria-labelledby="start-title">
      <h2 id="start-title">{START.drop}</h2>
      <p class="hint">{START.kinds}</p>
      <OpenButtons model={model} />
      <Recent model={model} />
      <h3>{START.faces}</h3>
      <div class="start-faces">
        {faces.value.map((name) => (
          <button key={name} type="button" onClick={() => actions.openFace(name)}>
            <img src={`faces/portraits/${name}.jpg`} alt="" width="112" height="112" />
            {displayName(name)}
          </button>
        ))}
      </div>
    </section>
  )
}
