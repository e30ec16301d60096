import type { WrinkleMode } from 'furrow/three'
import type { RendererKind } from '../../../stage/stage.ts'
import { type Appearance, chooseAppearance, chosenAppearance } from '../appearance.ts'
import { displayName } from '../display-name.ts'
import type { Look, LookName } from '../viewer/looks/look.ts'
import { Choice } from './controls/choice.tsx'
import { Section } from './controls/section.tsx'
import type { PanelModel } from './model.ts'
import { StagingControls } from './staging.tsx'

const RENDERERS: readonly { value: RendererKind; label: string }[] = [
  { value: 'webgl', label: 'WebGL' },
  { value: 'webgpu', label: 'WebGPU' },
]

const MODES: readonly { value: Exclude<WrinkleMode, 'composed'>; label: string; title?: string }[] = [
  { value: 'default', label: 'Default', title: 'Mixes normals, computes the lighting once' },
  { value: 'paper', label: 'Paper', title: 'Lights twice, mixes colours' },
  { value: 'off', label: 'Off' },
]

const LOOKS: readonly { value: LookName; label: string; title?: string }[] = [
  { value: 'shaded', label: 'Shaded' },
  { value: 'clay', label: 'Clay', title: 'The shape alone' },
  { value: 'normals', label: 'Normals' },
  { value: 'influence', label: 'Areas', title: 'Areas of influence times their activations' },
  { value: 'strain', label: 'Strain', title: 'How the current pose compresses and stretches the skin' },
  { value: 'onset', label: 'Onset', title: 'Activation at which the skin begins to wrinkle' },
  { value: 'wireframe', label: 'Wires' },
]

const APPEARANCES: readonly { value: Appearance; label: string; title?: string }[] = [
  { value: 'system', label: 'System', title: 'Follows the system' },
  { value: 'light', label: 'Light' },
  { value: 'dark', label: 'Dark' },
]

const ALL = 'All areas, as activated'

/** Face and view settings. */
export function Settings({ model }: { model: PanelModel }) {
  const { actions, revision } = model
  const viewer = model.viewer.value
  revision.value
  const look: Look = viewer?.look ?? { name: 'shaded' }
  return (
    <Section title="View">
      <div class="settings">
        <FaceChoice model={model} />
        <SkinChoice model={model} />
        <Choice
          label="Renderer"
          options={RENDERERS}
          value={viewer?.kind ?? 'webgl'}
          onChange={actions.setRenderer}
        />
        <Choice
          label="Wrinkles"
          options={MODES}
          value={(viewer?.mode ?? 'default') as (typeof MODES)[number]['value']}
          onChange={actions.setMode}
        />
        <Choice
          label="Show"
          options={LOOKS}
          columns={4}
          value={look.name}
          onChange={(name) => actions.setLook({ name })}
        />
        {look.name === 'strain' && (
          <p class="hint">Orange is compressed, blue is stretched: full colours from 30% on.</p>
        )}
        {look.name === 'onset' && <OnsetChoice model={model} shown={look.layer} />}
        {look.name === 'influence' && (
          <AreaChoice model={model} shown={typeof look.area === 'string' ? look.area : ''} />
        )}
        <StagingControls staging={model.staging} />
        <Choice label="Page" options={APPEARANCES} value={chosenAppearance()} onChange={chooseAppearance} />
      </div>
    </Section>
  )
}

/** Select for shipped faces and the current avatar. */
function FaceChoice({ model: { faces, viewer, actions } }: { model: PanelModel }) {
  const shown = viewer.value?.avatar.name
  const names = shown === undefined || faces.value.includes(shown) ? faces.value : [...faces.value, shown]
  return (
    <div class="setting">
      <label for="face">Face</label>
      <select
        id="face"
        value={shown ?? ''}
        onChange={({ currentTarget }) => actions.openFace(currentTarget.value)}
      >
        {names.map((name) => (
          <option key={name} value={name}>
            {displayName(name)}
          </option>
        ))}
      </select>
    </div>
  )
}

/** Select for the skin mesh, if there are several. */
function SkinChoice({ model: { viewer, actions } }: { model: PanelModel }) {
  const avatar = viewer.value?.avatar
  if (!avatar || avatar.skins.length < 2) return null
  return (
    <div class="setting">
      <label for="skin">Skin</label>
      <select
        id="skin"
        value={avatar.skin}
        onChange={({ currentTarget }) => actions.chooseSkin(Number(currentTarget.value))}
      >
        {avatar.skins.map(({ name, problem }, i) => (
          <option key={name} value={i} disabled={problem !== null} title={problem ?? undefined}>
            {name}
          </option>
        ))}
      </select>
    </div>
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
      <label for="area">Area</label>
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
