import { POSES } from '../labels/joints.ts'
import { VIEW, VIEW_HINTS } from '../labels/stage.ts'
import { Choice } from '../panels/controls/choice.tsx'
import type { PanelModel } from '../panels/model.ts'
import { StagingControls } from '../panels/staging.tsx'
import { Icon } from '../ui/icon.tsx'
import { Popover } from '../ui/popover.tsx'
import type { Look, LookName } from '../viewer/looks/look.ts'
import { REST_POSE } from '../viewer/pose/skeleton-pose.ts'

interface LookOption {
  value: LookName
  label: string
  title: string
}

/** Looks that are always in reach. */
const MAIN: readonly LookOption[] = [
  { value: 'shaded', label: VIEW.shaded, title: VIEW_HINTS.shaded },
  { value: 'clay', label: VIEW.clay, title: VIEW_HINTS.clay },
  { value: 'strain', label: VIEW.strain, title: VIEW_HINTS.strain },
]

const OTHERS: readonly LookOption[] = [
  { value: 'normals', label: VIEW.normals, title: VIEW_HINTS.normals },
  { value: 'influence', label: VIEW.influence, title: VIEW_HINTS.influence },
  { value: 'onset', label: VIEW.onset, title: VIEW_HINTS.onset },
  { value: 'wireframe', label: VIEW.wireframe, title: VIEW_HINTS.wireframe },
]

/** Controls in the corner of the stage: what it shows, the light and the turntable. */
export function Corner({ model }: { model: PanelModel }) {
  const { viewer, revision, staging, isSkeletonShown, actions } = model
  revision.value
  const hasSkeleton = (viewer.value?.skeleton.joints.length ?? 0) > 1
  const look: Look = viewer.value?.look ?? { name: 'shaded' }
  const choose = (name: LookName) => actions.setLook({ name })
  return (
    <>
      {look.name === 'strain' && <p class="hint">{VIEW_HINTS.strainColours}</p>}
      {hasSkeleton && isSkeletonShown.value && <SkeletonHint model={model} />}
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
        {hasSkeleton && (
          <button
            type="button"
            class="plain"
            aria-label={POSES.skeleton}
            aria-pressed={isSkeletonShown.value}
            title={POSES.skeleton}
            onClick={() => {
              isSkeletonShown.value = !isSkeletonShown.peek()
            }}
          >
            <Icon name="skeleton" />
          </button>
        )}
      </div>
    </>
  )
}

/** Tells how to pose the skeleton, and resets it. */
function SkeletonHint({ model: { actions } }: { model: PanelModel }) {
  return (
    <div class="skeleton-hint">
      <p class="hint">{POSES.skeletonHint}</p>
      <button type="button" onClick={() => actions.playPose(REST_POSE)}>
        {POSES.rest}
      </button>
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
  if (names.length === 0) return <p class="hint">{VIEW_HINTS.noOnset}</p>
  return (
    <>
      <div class="setting">
        <label for="onset-layer">{VIEW.onsetOf}</label>
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
      <p class="hint">{VIEW_HINTS.onsetColours}</p>
    </>
  )
}

function AreaChoice({ model: { viewer, actions }, shown }: { model: PanelModel; shown: string }) {
  return (
    <div class="setting">
      <label for="area">{VIEW.region}</label>
      <select
        id="area"
        value={shown}
        onChange={({ currentTarget: { value } }) => {
          actions.setLook({ name: 'influence', ...(value && { area: value }) })
        }}
      >
        <option value="">{VIEW.allRegions}</option>
        {viewer.value?.areas.map(({ name }) => (
          <option key={name} value={name}>
            {name}
          </option>
        ))}
      </select>
    </div>
  )
}
