/** Returns the name for the other side of the body if a name ends in `Left` or `Right`; otherwise the same name. */
export function mirroredName(name: string): string {
  return name.replace(/(Left|Right)$/, (side) => (side === 'Left' ? 'Right' : 'Left'))
}
