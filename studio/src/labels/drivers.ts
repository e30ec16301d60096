/** Returns the label of problems with drivers: `1 problem`. */
export function problemsLabel(count: number): string {
  return count === 1 ? '1 problem' : `${count} problems`
}
