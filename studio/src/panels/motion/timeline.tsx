import { rangeOf } from '../../document/take.ts'
import { ANIMATION, speedLabel, timeLabel } from '../../labels/animation.ts'
import type { ClipPlayer } from '../../viewer/pose/clip-player.ts'
import { Check } from '../controls/check.tsx'
import type { PanelModel } from '../model.ts'
import { Curves } from './curves.tsx'

const SPEEDS = ['0.25', '0.5', '1', '2']

/** Timeline of the chosen take or animation below the face, in the mode Motion. */
export function Timeline({ model }: { model: PanelModel }) {
  const { tools, player, takes, live, viewer } = model
  const { clip, isPlaying, isShown, isLooped, speed } = player
  if (tools.mode.value !== 'motion' || !viewer.value || !clip.value) return null
  const take = takes.chosen.value
  const { duration } = clip.value.animation
  return (
    <div class="track">
      {take && (
        <div class="lane">
          <Curves motion={take.motion} />
          <Trimmed range={rangeOf(take)} duration={duration} />
        </div>
      )}
      <Time player={player} duration={duration} />
      <div class="transport">
        <button
          type="button"
          aria-keyshortcuts="Space"
          disabled={live.recorded.value !== null}
          onClick={() => player.toggle()}
        >
          {isPlaying.value ? ANIMATION.pause : ANIMATION.play}
        </button>
        <button
          type="button"
          disabled={!isShown.value}
          title={ANIMATION.stopHint}
          onClick={() => player.stop()}
        >
          {ANIMATION.stop}
        </button>
        {take &&
          (['in', 'out'] as const).map((end) => (
            <button
              key={end}
              type="button"
              title={ANIMATION[`${end}Hint`]}
              aria-keyshortcuts={end[0]}
              onClick={() => takes.trimAtTime(end)}
            >
              {ANIMATION[end]}
            </button>
          ))}
        <Check value={isLooped}>{ANIMATION.loop}</Check>
        <select
          aria-label={ANIMATION.speed}
          title={ANIMATION.speed}
          value={`${speed.value}`}
          onChange={({ currentTarget }) => {
            speed.value = Number(currentTarget.value)
          }}
        >
          {SPEEDS.map((value) => (
            <option key={value} value={value}>
              {speedLabel(value)}
            </option>
          ))}
        </select>
      </div>
    </div>
  )
}

/** Shades the parts before the in point and after the out point. */
function Trimmed({ range: [start, end], duration }: { range: readonly [number, number]; duration: number }) {
  return (
    <>
      <span class="trimmed" style={{ left: 0, width: `${(100 * start) / duration}%` }} />
      <span class="trimmed" style={{ right: 0, width: `${100 - (100 * end) / duration}%` }} />
    </>
  )
}

interface TimeProps {
  player: ClipPlayer
  duration: number
}

interface TimeProps {
  player: ClipPlayer
  duration: number
}

/** Slider for the time in the clip. It is a component, so that each frame renders only this part. */
function Time({ player, duration }: TimeProps) {
  const time = player.time.value
  const text = timeLabel(time, duration)
  return (
    <>
      <input
        type="range"
        aria-label={ANIMATION.time}
        aria-valuetext={text}
        min={0}
        max={duration || 1}
        step={0.01}
        value={time}
        style={{ '--value': time / (duration || 1) }}
        onInput={({ currentTarget }) => player.scrub(currentTarget.valueAsNumber)}
      />
      <span class="time">{text}</span>
    </>
  )
}
