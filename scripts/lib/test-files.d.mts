export interface TestFile {
  project: string
  file: string
}

export const PROMISES: readonly string[]
export const MORE_CASES: readonly string[]
export function isQuick(test: TestFile): boolean
export function isInAll(test: TestFile): boolean
export function listTests(): Promise<TestFile[]>
