import { clipLabel } from '../../labels/animation.ts'
import { durationLabel } from '../../labels/live.ts'
import type { Clip, ClipPlayer } from '../../viewer/pose/clip-player.ts'

interface ClipListProps {
  /** Accessible name of the list. */
  label: string
  clips: readonly Clip[]
  player: ClipPlayer
}

/** List of animations or takes. A press chooses one for the timeline. */
export function ClipList({ label, clips, player }: ClipListProps) {
  return (
    <ul class="clips" aria-label={label}>
      {clips.map((clip, i) => {
        const [start, end] = clip.range
        return (
          <li key={clip.animation.uuid}>
            <button
              type="button"
              aria-pressed={player.clip.value?.animation === clip.animation}
              onClick={() => player.choose(clip)}
            >
              <span>{clip.name || clipLabel(i + 1)}</span>
              <small>{durationLabel(end - start)}</small>
            </button>
          </li>
        )
      })}
    </ul>
  )
}
