import type { TensionDriver } from 'furrow'
import { TENSION } from '../../../labels/driver-forms.ts'
import { DRIVER_TYPES } from '../../../labels/drivers.ts'
import { NumberSlider } from '../../controls/number-slider.tsx'
import { type Axis, axisOf } from '../axes.ts'
import type { FormProps } from '../context.ts'
import { DriverCurve, SelectField } from '../fields.tsx'
import type { DriverType } from './driver-type.ts'

export const tension: DriverType<TensionDriver> = {
  label: DRIVER_TYPES.tension,
  axis: inputAxis,
  create: (area) => ({
    type: 'tension',
    area,
    measure: 'compression',
    // The inputs are fractions by which creasing skin becomes shorter.
    curve: [
      [0.03, 0],
      [0.2, 1],
    ],
  }),
  Form: TensionForm,
}

/** Returns the input axis of the driver's curve. */
function inputAxis({ measure, curve }: TensionDriver): Axis {
  return axisOf('tension', measure === 'compression' ? TENSION.shortened : TENSION.lengthened, curve)
}

function TensionForm({ driver, index, context }: FormProps<TensionDriver>) {
  const { measure, direction, curve } = driver
  const turn = (angle: number | null) =>
    context.editor.set(index, 'direction', { direction: angle === null ? undefined : directionAt(angle) })
  return (
    <>
      <SelectField
        label={TENSION.measure}
        value={measure}
        options={[
          ['compression', TENSION.compression],
          ['stretch', TENSION.stretch],
        ]}
        onChange={(next) => {
          context.editor.set(index, 'measure', { measure: next })
          context.editor.settle()
        }}
      />
      <SelectField
        label={TENSION.along}
        value={direction ? 'one' : 'any'}
        options={[
          ['any', TENSION.anyDirection],
          ['one', TENSION.oneDirection],
        ]}
        onChange={(next) => {
          turn(next === 'one' ? 0 : null)
          context.editor.settle()
        }}
      />
      {direction && (
        <NumberSlider
          label={TENSION.angle}
          range={[0, 180, 5]}
          value={angleOf(direction)}
          text={`${Math.round(angleOf(direction))}°`}
          onMove={turn}
          onRest={() => context.editor.settle()}
        />
      )}
      <DriverCurve {...{ index, context, curve }} axis={inputAxis(driver)} />
    </>
  )
}

/** Returns the angle of a direction in the texture, degrees from u towards v, 0..180. Opposite directions have the same angle. */
function angleOf([u, v]: readonly [number, number]): number {
  const degrees = (Math.atan2(v, u) * 180) / Math.PI
  return degrees < 0 ? degrees + 180 : degrees
}

function directionAt(degrees: number): [number, number] {
  const radians = (degrees * Math.PI) / 180
  const rounded = (value: number) => Math.round(value * 1e4) / 1e4
  return [rounded(Math.cos(radians)), rounded(Math.sin(radians))]
}
