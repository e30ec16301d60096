/** Converts an identifier to a label: `leftBrow` becomes `Left brow`. */
export function displayName(name: string): string {
  const words = name.replace(/[-_]+/g, ' ').replace(/([a-z])([A-Z0-9])/g, '$1 $2')
  return words.charAt(0).toUpperCase() + words.slice(1).toLowerCase()
}
