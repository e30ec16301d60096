import { useId } from 'preact/hooks'

interface TextFieldProps {
  label: string
  /** Accessible name, if it differs from the label. */
  fullLabel?: string
  placeholder?: string
  value: string
  /** Called at each key press. */
  onInput?(value: string): void
  /** Called when the user has finished. Afterwards, the field shows `value` again, in case the text was refused. */
  onChange?(value: string): void
}

/** Text field with its label. */
export function TextField({ label, fullLabel, placeholder, value, onInput, onChange }: TextFieldProps) {
  const id = useId()
  return (
    <div class="setting">
      <label for={id}>{label}</label>
      <input
        id={id}
        type="text"
        aria-label={fullLabel}
        autocomplete="off"
        spellcheck={false}
        placeholder={placeholder}
        value={value}
        onInput={({ currentTarget }) => onInput?.(currentTarget.value)}
        onChange={({ currentTarget }) => {
          if (!onChange) return
          onChange(currentTarget.value)
          currentTarget.value = value
        }}
      />
    </div>
  )
}
