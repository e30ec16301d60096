export interface Source {
  path: string
  imports: string[]
}
export function readImports(folders: string[]): Source[]

export interface Import {
  specifier: string
  isDynamic: boolean
}
export function importsIn(name: string, text: string): Import[]
