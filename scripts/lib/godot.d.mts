import type { Plugin } from 'vite'

export function serveGodot(): Plugin
export function setUpGodot(): Promise<void>
