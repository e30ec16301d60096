export interface Source {
  path: string
  imports: string[]
}
export function readImports(folders: string[]): Source[]
