// Signatures that docs/frameworks.md uses, copied from the packages: installing them for two calls would take minutes.

/** @threlte/core 8.6.0, dist/hooks/useLoader.d.ts */
declare module '@threlte/core' {
  type AsyncLoader = { loadAsync: (url: string) => Promise<unknown> }
  export function useLoader<Proto extends new (...args: never[]) => AsyncLoader>(
    Proto: Proto,
    options?: { extend?: (loader: InstanceType<Proto>) => void },
  ): { load(url: string): Promise<Awaited<ReturnType<InstanceType<Proto>['loadAsync']>>> }
  export function useThrelte(): { invalidate(): void }
  export const T: unknown
}

/** svelte 5.57.3 */
declare module 'svelte' {
  export function onMount(start: () => () => void): void
}
declare function $props(): { address: string }

/** @tresjs/core 5.9.1, dist/tres.d.ts */
declare module '@tresjs/core' {
  type TresLoader<T> = import('three').Loader & { loadAsync: (url: string) => Promise<T> }
  export function useLoader<T>(
    Loader: new (manager?: import('three').LoadingManager) => TresLoader<T>,
    path: string,
    options?: { extensions?: (loader: TresLoader<T>) => void },
  ): { state: { value: T } }
}

/** aframe 1.8.0, which has no types: https://aframe.io/docs/1.7.0/core/component.html */
declare module 'aframe' {
  interface Component {
    data: string
    el: {
      setObject3D(type: string, object: import('three').Object3D): void
      removeObject3D(type: string): void
      emit(name: string, detail: object): void
      addEventListener(type: string, listener: (event: Event) => void): void
    }
    live: unknown
  }
  const AFRAME: {
    registerComponent(
      name: string,
      definition: { schema: object; init?(): void; update?(): void; remove(): void } & ThisType<Component>,
    ): void
  }
  export default AFRAME
}
