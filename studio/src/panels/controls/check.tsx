import type { Signal } from '@preact/signals'
import type { ComponentChildren } from 'preact'

interface CheckProps {
  value: Signal<boolean>
  title?: string
  children: ComponentChildren
}

/** Check box with its label. */
export function Check({ value, title, children }: CheckProps) {
  return (
    <label class="check" title={title}>
      <input
        type="checkbox"
        checked={value.value}
        onChange={({ currentTarget }) => {
          value.value = currentTarget.checked
        }}
      />
      {children}
    </label>
  )
}
