/** A group of radio buttons; `show` sets it without calling `onChange`. */
export class Choice<T extends string> {
  readonly #inputs: HTMLInputElement[]

  /** @param root a fieldset with radio inputs whose values are those of T. */
  constructor(root: HTMLElement, onChange: (value: T) => void) {
    this.#inputs = [...root.querySelectorAll<HTMLInputElement>('input[type=radio]')]
    for (const input of this.#inputs) input.addEventListener('change', () => onChange(input.value as T))
  }

  get value(): T {
    return this.#inputs.find(({ checked }) => checked)!.value as T
  }

  show(value: T): void {
    for (const input of this.#inputs) input.checked = input.value === value
  }

  set disabled(disabled: boolean) {
    for (const input of this.#inputs) input.disabled = disabled
  }
}
