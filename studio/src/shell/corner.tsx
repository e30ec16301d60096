import { VIEW } from '../labels/stage.ts'
import { Choice } from '../panels/controls/choice.tsx'
import type { PanelModel } from '../panels/model.ts'
import { StagingControls } from '../panels/staging.tsx'
import { Icon } from '../ui/icon.tsx'
import { Popover } from '../ui/popover.tsx'
import type { Look, LookName } from '../viewer/looks/look.ts'

interface LookOption {
  value: LookName
  label: string
  title: string
}

/** Looks that are always in reach. */
const MAIN: readonly LookOption[] = [
  { value: 'shaded', label: VIEW.shaded, title: 'The skin as in the file' },
  { value: 'clay', label: VIEW.clay, title: 'The shape alone' },
  { value: 'strain', label: VIEW.strain, title: 'How the current pose compresses and stretches the skin' },
]

const OTHERS: readonly LookOption[] = [
  { value: 'normals', label: VIEW.normals, title: 'Directions of the surface' },
  { value: 'influence', label: VIEW.influence, title: 'Regions times their activations' },
  { value: 'onset', label: VIEW.onset, title: 'Activation at which the skin begins to wrinkle' },
  { value: 'wireframe', label: VIEW.wireframe, title: 'Edges of the triangles' },
]

const ALL = 'All regions, as activated'

/** Controls in the corner of the stage: what it shows, the light and the turntable. */
export function Corner({ model }: { model: PanelModel }) {
  const { viewer, revision, staging, actions } = model
  revision.value
  const look: Look = viewer.value?.look ?? { name: 'shaded' }
  const choose = (name: LookName) => actions.setLook({ name })
  return (
    <>
      {look.name === 'strain' && (
        <p class="hint">Orange is compressed, blue is stretched: full colours from 30% on.</p>
      )}
      <div class="corner-row">
        <Choice label={VIEW.show} options={MAIN} value={look.name} onChange={choose} />
        <Popover label={VIEW.more} class="plain" placement="top-end" button={<Icon name="more" />}>
          <Choice label={VIEW.more} options={OTHERS} columns={2} value={look.name} onChange={choose} />
          {look.name === 'onset' && <OnsetChoice model={model} shown={look.layer} />}
          {look.name === 'influence' && (
            <AreaChoice model={model} shown={typeof look.area === 'string' ? look.area : ''} />
          )}
        </Popover>
        <StagingControls staging={staging} />
      </div>
    </>
  )
}

/** Chooses the layer whose onset map is shown, and explains the colours. */
function OnsetChoice({
  model: { viewer, actions },
  shown,
}: {
  model: PanelModel
  shown: string | undefined
}) {
  const names = [...(viewer.value?.onsets.keys() ?? [])]
  if (names.length === 0) return <p class="hint">No layer has an onset map, so all lines begin at once.</p>
  return (
    <>
      <div class="setting">
        <label for="onset-layer">Onset of</label>
        <select
          id="onset-layer"
          value={shown ?? names[0]}
          onChange={({ currentTarget }) => actions.setLook({ name: 'onset', layer: currentTarget.value })}
        >
          {names.map((name) => (
            <option key={name} value={name}>
              {name}
            </option>
          ))}
        </select>
      </div>
      <p class="hint">
        Orange begins to wrinkle early, blue late: full blue from activation 0.5 on. Dark has no delay.
      </p>
    </>
  )
}

function AreaChoice({ model: { viewer, actions }, shown }: { model: PanelModel; shown: string }) {
  return (
    <div class="setting">
      <label for="area">Region</label>
      <select
        id="area"
        value={shown}
        onChange={({ currentTarget: { value } }) => {
          actions.setLook({ name: 'influence', ...(value && { area: value }) })
        }}
      >
        <option value="">{ALL}</option>
        {viewer.value?.areas.map(({ name }) => (
          <option key={name} value={name}>
            {name}
          </option>
        ))}
      </select>
    </div>
  )
}
