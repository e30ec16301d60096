import { ANIMATION, clipLabel, speedLabel } from '../labels/animation.ts'
import { PLACES } from '../labels/page.ts'
import type { ClipPlayer } from '../viewer/pose/clip-player.ts'
import { Check } from './controls/check.tsx'
import { Choice } from './controls/choice.tsx'
import { FileButton } from './controls/file-button.tsx'
import { NumberSlider } from './controls/number-slider.tsx'
import { Section } from './controls/section.tsx'

const SPEEDS = ['0.25', '0.5', '1', '2'].map((value) => ({ value, label: speedLabel(value) }))

interface AnimationProps {
  player: ClipPlayer
  onOpen(files: readonly File[]): void
}

/** Plays animations of the avatar's file, and facial captures. */
export function Animation({ player, onOpen }: AnimationProps) {
  return (
    <Section title={PLACES.animation}>
      {player.clips.value.length === 0 ? <p class="hint">{ANIMATION.none}</p> : <Clips player={player} />}
      <FileButton accept=".csv" onChoose={onOpen}>
        {ANIMATION.openCapture}
      </FileButton>
    </Section>
  )
}

function Clips({ player }: { player: ClipPlayer }) {
  const { clips, clip, isPlaying, isShown, isLooped, speed } = player
  return (
    <div class="settings">
      <div class="setting">
        <label for="clip">{ANIMATION.clip}</label>
        <select
          id="clip"
          value={clips.value.indexOf(clip.value!)}
          onChange={({ currentTarget }) => player.choose(clips.value[Number(currentTarget.value)])}
        >
          {clips.value.map(({ uuid, name }, i) => (
            <option key={uuid} value={i}>
              {name || clipLabel(i + 1)}
            </option>
          ))}
        </select>
      </div>
      <Time player={player} />
      <div class="work">
        <button type="button" onClick={() => (isPlaying.value ? player.pause() : player.play())}>
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
        <Check value={isLooped}>{ANIMATION.loop}</Check>
      </div>
      <Choice
        label={ANIMATION.speed}
        options={SPEEDS}
        value={`${speed.value}`}
        onChange={(value) => {
          speed.value = Number(value)
        }}
      />
    </div>
  )
}

/** Slider for the time in the clip. It is a component, so that each frame renders only this part. */
function Time({ player }: { player: ClipPlayer }) {
  const { clip, time } = player
  return (
    <NumberSlider
      label={ANIMATION.time}
      range={[0, clip.value?.duration || 1, 0.01]}
      value={time.value}
      text={time.value.toFixed(1)}
      onMove={(seconds) => player.scrub(seconds)}
    />
  )
}
