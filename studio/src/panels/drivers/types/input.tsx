import type { InputDriver } from 'furrow'
import { INPUT } from '../../../labels/driver-forms.ts'
import { DRIVER_TYPES } from '../../../labels/drivers.ts'
import { type Axis, axisOf } from '../axes.ts'
import type { FormProps } from '../context.ts'
import { DriverCurve, NameField } from '../fields.tsx'
import { InputSlider } from '../input-slider.tsx'
import { type DriverType, freeDriverName } from './driver-type.ts'

export const input: DriverType<InputDriver> = {
  label: DRIVER_TYPES.input,
  reads: ({ name }) => name,
  axis: inputAxis,
  create: (area, document) => ({
    type: 'input',
    area,
    name: freeDriverName(document, 'stress'),
    curve: [
      [0, 0],
      [1, 1],
    ],
  }),
  Form: InputForm,
}

/** Returns the input axis of the driver's curve. */
function inputAxis({ name, curve }: InputDriver): Axis {
  return axisOf('number', name, curve)
}

function InputForm({ driver, index, context }: FormProps<InputDriver>) {
  const { name, curve } = driver
  const axis = inputAxis(driver)
  return (
    <>
      <NameField
        label={INPUT.name}
        value={name}
        onChange={(next) => {
          context.editor.set(index, 'name', { name: next })
          context.editor.settle()
        }}
      />
      <p class="hint">{INPUT.hint}</p>
      <DriverCurve {...{ index, context, curve, axis }} />
      <InputSlider name={name} label={INPUT.try} axis={axis} context={context} />
    </>
  )
}
