import { type ReadonlySignal, useComputed } from '@preact/signals'
import type { Curve } from 'furrow'
import type { Contribution } from 'furrow/internal'
import { useId } from 'preact/hooks'
import { curveNowLabel } from '../../labels/drivers.ts'
import { LabelledGroup } from '../controls/labelled-group.tsx'
import { TextField } from '../controls/text-field.tsx'
import { type Axis, textOn } from './axes.ts'
import type { DriverContext } from './context.ts'
import { CurveEditor } from './curve-editor.tsx'
import { NumberField } from './number-field.tsx'

interface NameFieldProps {
  label: string
  value: string
  onChange(value: string): void
}

/** Text field for a name. Rejects an empty name. */
export function NameField({ label, value, onChange }: NameFieldProps) {
  return (
    <TextField
      label={label}
      value={value}
      onChange={(text) => {
        const name = text.trim()
        if (name !== '' && name !== value) onChange(name)
      }}
    />
  )
}

interface SelectFieldProps {
  label: string
  value: string
  options: readonly (readonly [value: string, label: string])[]
  onChange(value: string): void
}

export function SelectField({ label, value, options, onChange }: SelectFieldProps) {
  const id = useId()
  return (
    <div class="setting">
      <label for={id}>{label}</label>
      <NameSelect {...{ id, value, options, onChange }} />
    </div>
  )
}

interface NameSelectProps extends Omit<SelectFieldProps, 'label'> {
  id?: string
  label?: string
}

/** Select for a name. Lists the current value too, even if the face lacks it. */
export function NameSelect({ id, label, value, options, onChange }: NameSelectProps) {
  const isKnown = options.some(([each]) => each === value)
  return (
    <select
      {...(id !== undefined && { id })}
      aria-label={label}
      title={value}
      value={value}
      onChange={({ currentTarget }) => onChange(currentTarget.value)}
    >
      {!isKnown && <option value={value}>{value}</option>}
      {options.map(([each, text]) => (
        <option key={each} value={each}>
          {text}
        </option>
      ))}
    </select>
  )
}

/** Makes options whose labels are equal to their values. */
export function optionsOf(names: readonly string[]): (readonly [string, string])[] {
  return names.map((name) => [name, name])
}

interface NumberSettingProps {
  label: string
  value: number
  step: number
  range?: readonly [number, number]
  unit?: string
  onChange(value: number): void
}

/** Number field with its label in the label column. */
export function NumberSetting(props: NumberSettingProps) {
  return (
    <div class="number-setting">
      <NumberField {...props} />
    </div>
  )
}

interface VectorSettingProps {
  label: string
  value: readonly [number, number, number]
  step: number
  /** Factor by which stored numbers are multiplied for display. */
  factor?: number
  unit?: string
  onChange(value: [number, number, number]): void
}

export function VectorSetting({ label, value, step, factor = 1, unit, onChange }: VectorSettingProps) {
  return (
    <LabelledGroup class="vector" label={unit ? `${label}, ${unit}` : label}>
      {(['x', 'y', 'z'] as const).map((axis, i) => (
        <NumberField
          key={axis}
          label={axis}
          value={value[i] * factor}
          step={step}
          onChange={(next) =>
            onChange(value.map((old, k) => (k === i ? next / factor : old)) as [number, number, number])
          }
        />
      ))}
    </LabelledGroup>
  )
}

interface DriverCurveProps {
  index: number
  context: DriverContext
  curve: Curve
  axis: Axis
}

/** Editor for the curve that maps a driver's input to its activation. */
export function DriverCurve({ index, context: { editor, now, slow }, curve, axis }: DriverCurveProps) {
  const input = useComputed(() => now.value[index]?.combined ?? null)
  return (
    <>
      <CurveEditor
        label={axis.label}
        curve={curve}
        axis={axis}
        outputs={[0, 1]}
        now={input}
        onMove={(next) => editor.set(index, 'curve', { curve: next })}
        onRest={() => editor.settle()}
      />
      <Reading contributions={slow} index={index} axis={axis} />
    </>
  )
}

interface ReadingProps {
  contributions: ReadonlySignal<readonly (Contribution | null)[]>
  index: number
  axis: Axis
}

/** Text with the current input and output of the curve. */
function Reading({ contributions, index, axis }: ReadingProps) {
  const text = useComputed(() => {
    const now = contributions.value[index]
    if (!now) return ''
    return curveNowLabel(textOn(axis, now.combined), now.activation)
  })
  return <p class="hint reading">{text}</p>
}
