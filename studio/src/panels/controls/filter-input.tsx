import type { Signal } from '@preact/signals'
import { TARGETS } from '../../labels/blendshapes.ts'

interface FilterInputProps {
  label: string
  id?: string | undefined
  /** Receives the text. */
  filter: Signal<string>
}

/** Text field that filters a list of blendshapes by name. */
export function FilterInput({ label, id, filter }: FilterInputProps) {
  return (
    <input
      id={id}
      type="search"
      aria-label={label}
      placeholder={TARGETS.example}
      autocomplete="off"
      spellcheck={false}
      value={filter.value}
      onInput={({ currentTarget }) => {
        filter.value = currentTarget.value
      }}
    />
  )
}
