import { effect, type ReadonlySignal } from '@preact/signals'
import type { ComponentChildren } from 'preact'
import { useId, useLayoutEffect, useRef } from 'preact/hooks'
import { splitSide } from '../../document/sides.ts'
import type { Dial } from '../../viewer/pose/dials.ts'

interface SliderProps {
  dial: Dial
  /** Label before the dial's name. Default: only the name. */
  label?: string
  /** Signal that changes when the dial's value may have changed. */
  frame: ReadonlySignal<number>
  onInput(dial: Dial, value: number): void
  /** Called with the dial when the mouse enters its label, and with null when the mouse leaves. */
  onHover?(dial: Dial | null): void
  /** Whether to highlight the row, because a driver connects the dial with the area or blendshape under the pointer. */
  linked?: boolean
  isHidden?: boolean
  before?: ComponentChildren
  /** Content after the value, such as buttons. */
  children?: ComponentChildren
}

/** Labelled slider for a dial. If the value changes, updates the DOM without rendering the component. */
export function Slider({
  dial,
  label,
  frame,
  onInput,
  onHover,
  linked = false,
  isHidden = false,
  before,
  children,
}: SliderProps) {
  const id = useId()
  const [start, side] = splitSide(dial.name)
  const input = useRef<HTMLInputElement>(null)
  const output = useRef<HTMLOutputElement>(null)
  // `useSignalEffect` would wait for the next frame, and the slider would first show an old value.
  useLayoutEffect(() => {
    return effect(() => {
      frame.value
      showNumber(input.current!, output.current!, dial.read())
    })
  }, [dial, frame])
  const isHovered = useRef(false)
  const hover = (hovered: boolean) => {
    if (isHovered.current === hovered) return
    isHovered.current = hovered
    onHover?.(hovered ? dial : null)
  }
  return (
    <div
      hidden={isHidden}
      class={`row${children ? ' removable' : ''}${before ? ' choosable' : ''}${linked ? ' linked' : ''}`}
    >
      {before}
      <label
        for={id}
        title={dial.name}
        // Ignore touches, and events that scrolling causes while the mouse rests.
        onPointerMove={({ pointerType, movementX, movementY }) => {
          if (pointerType === 'mouse' && (movementX !== 0 || movementY !== 0)) hover(true)
        }}
        onPointerLeave={() => hover(false)}
      >
        {label && <span>{label} </span>}
        <span class={label && 'file-name'}>
          {start}
          <wbr />
          {side}
        </span>
      </label>
      <input
        ref={input}
        id={id}
        type="range"
        min="0"
        max="1"
        step="0.01"
        onInput={({ currentTarget }) => {
          onInput(dial, currentTarget.valueAsNumber)
          showNumber(currentTarget, output.current!, dial.read())
        }}
      />
      {/* Screen readers announce the value of the input. They must not also announce each change of the output. */}
      <output ref={output} for={id} aria-live="off" />
      {children}
    </div>
  )
}

/** Updates the DOM only if the displayed number changed. */
function showNumber(input: HTMLInputElement, output: HTMLOutputElement, value: number): void {
  const text = value.toFixed(2)
  if (output.textContent === text) return
  input.value = text
  input.style.setProperty('--value', text)
  output.textContent = text
}
