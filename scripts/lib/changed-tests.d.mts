export function changedFirst<T extends { file: string }>(tests: T[]): T[]
