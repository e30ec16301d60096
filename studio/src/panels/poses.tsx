import { useMemo } from 'preact/hooks'
import { POSES, poseLabel } from '../labels/joints.ts'
import { REGION } from '../labels/regions.ts'
import { REST_POSE } from '../viewer/pose/skeleton-pose.ts'
import { Section } from './controls/section.tsx'
import { Slider } from './controls/slider.tsx'
import type { PanelModel } from './model.ts'

/** Sliders for the amounts of the poses of joints. */
export function Poses({ model: { viewer, revision, frame, actions } }: { model: PanelModel }) {
  revision.value
  const dials = viewer.value?.poses
  const named = useMemo(
    () => dials?.map((dial) => ({ dial, shown: { ...dial, name: poseLabel(dial.name) } })) ?? [],
    [dials],
  )
  if (named.length === 0) return null
  const aside = (
    <button type="button" class="quiet" aria-label={POSES.rest} onClick={() => actions.playPose(REST_POSE)}>
      {REGION.reset}
    </button>
  )
  return (
    <Section title={POSES.title} aside={aside}>
      <div id="pose-sliders" class="groups">
        {named.map(({ dial, shown }) => (
          <Slider
            key={dial.name}
            dial={shown}
            frame={frame}
            onInput={(_, value) => actions.input(dial, value)}
          />
        ))}
      </div>
    </Section>
  )
}
