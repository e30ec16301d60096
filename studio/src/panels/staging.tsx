import { lightLabel, VIEW, VIEW_HINTS } from '../labels/stage.ts'
import { reducedMotion } from '../motion.ts'
import { Icon } from '../ui/icon.tsx'
import { ballPoint, clampedLight, lightOnBall } from '../viewer/light-direction.ts'
import { KEY_LIGHT, type Staging } from '../viewer/staging.ts'

/** Rotation of the light per key press, degrees. */
const STEP = 5

/** Controls of the stage: a ball on which the user drags the light, and the turntable. */
export function StagingControls({ staging }: { staging: Staging }) {
  return (
    <div class="staging">
      <LightBall staging={staging} />
      <button
        type="button"
        class="plain"
        aria-label={VIEW.turntable}
        aria-pressed={staging.turntable.value}
        disabled={reducedMotion.matches}
        title={reducedMotion.matches ? VIEW_HINTS.still : VIEW.turntable}
        onClick={() => {
          staging.turntable.value = !staging.turntable.peek()
        }}
      >
        <Icon name="turn" />
      </button>
    </div>
  )
}

function LightBall({ staging: { light } }: { staging: Staging }) {
  const { yaw, pitch } = light.value
  const [x, y] = ballPoint(light.value)
  const drag = (event: PointerEvent) => {
    const { left, top, width, height } = (event.currentTarget as HTMLElement).getBoundingClientRect()
    const across = (2 * (event.clientX - left)) / width - 1
    const up = 1 - (2 * (event.clientY - top)) / height
    light.value = lightOnBall(across, up)
  }
  const turn = (event: KeyboardEvent) => {
    const steps: Record<string, readonly [number, number]> = {
      ArrowLeft: [-STEP, 0],
      ArrowRight: [STEP, 0],
      ArrowUp: [0, STEP],
      ArrowDown: [0, -STEP],
    }
    const step = steps[event.key]
    if (!step && event.key !== 'Home') return
    event.preventDefault()
    light.value = step ? clampedLight({ yaw: yaw + step[0], pitch: pitch + step[1] }) : KEY_LIGHT
  }
  return (
    <div
      class="ball"
      role="slider"
      tabIndex={0}
      title={VIEW_HINTS.light}
      aria-label={VIEW.light}
      aria-valuemin={-90}
      aria-valuemax={90}
      aria-valuenow={yaw}
      aria-valuetext={lightLabel(yaw, pitch)}
      style={{ '--x': `${50 + 50 * x}%`, '--y': `${50 - 50 * y}%` }}
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId)
        drag(event)
      }}
      onPointerMove={(event) => {
        if (event.currentTarget.hasPointerCapture(event.pointerId)) drag(event)
      }}
      onDblClick={() => {
        light.value = KEY_LIGHT
      }}
      onKeyDown={turn}
    />
  )
}
