import type { Signal } from '@preact/signals'
import type { ComponentChildren } from 'preact'

interface CheckBoxProps {
  isChecked: boolean
  title?: string | undefined
  onChange(isChecked: boolean): void
  children: ComponentChildren
}

/** Check box with its label. */
export function CheckBox({ isChecked, title, onChange, children }: CheckBoxProps) {
  return (
    <label class="check" title={title}>
      <input
        type="checkbox"
        checked={isChecked}
        onChange={({ currentTarget }) => onChange(currentTarget.checked)}
      />
      {children}
    </label>
  )
}

interface CheckProps extends Pick<CheckBoxProps, 'title' | 'children'> {
  value: Signal<boolean>
}

/** Check box that sets a signal. */
export function Check({ value, ...props }: CheckProps) {
  return (
    <CheckBox
      {...props}
      isChecked={value.value}
      onChange={(isChecked) => {
        value.value = isChecked
      }}
    />
  )
}
