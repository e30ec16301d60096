import { NumberSlider } from '../controls/number-slider.tsx'
import type { Axis } from './axes.ts'
import type { DriverContext } from './context.ts'

interface InputSliderProps {
  name: string
  label: string
  axis: Axis
  context: DriverContext
}

/** Slider that sets a custom input of drivers. The value is not part of the document. */
export function InputSlider({ name, label, axis: { range }, context: { model } }: InputSliderProps) {
  const { viewer, frame, actions } = model
  frame.value
  const dial = viewer.value?.driven.inputDial(name)
  if (!dial) return null
  const step = (range[1] - range[0]) / 100 >= 0.5 ? 1 : (range[1] - range[0]) / 100
  return (
    <NumberSlider
      label={label}
      range={[...range, step]}
      value={dial.read()}
      onMove={(value) => actions.input(dial, value)}
      onRest={(value) => actions.input(dial, value)}
    />
  )
}
