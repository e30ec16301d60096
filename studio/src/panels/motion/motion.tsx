import { PLACES } from '../../labels/page.ts'
import { Section } from '../controls/section.tsx'
import type { PanelModel } from '../model.ts'
import { ClipList } from './clip-list.tsx'
import { LiveSection } from './live-section.tsx'
import { TakesSection } from './takes-section.tsx'

/** Everything that moves the face: live sources, takes, and animations of the avatar's file. */
export function Motion({ model }: { model: PanelModel }) {
  const { player } = model
  const animations = player.own.value
  return (
    <>
      <LiveSection model={model} />
      <TakesSection model={model} />
      {animations.length > 0 && (
        <Section title={PLACES.animations}>
          <ClipList label={PLACES.animations} clips={animations} player={player} />
        </Section>
      )}
    </>
  )
}
