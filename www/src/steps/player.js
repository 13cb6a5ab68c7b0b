/** Goes through the steps by itself, one each beat. */

/** Milliseconds of a step at the speed 1. */
const BEAT = 500;

/**
 * @param {() => boolean} advance goes on by a step; false at the last one
 * @param {() => void} ended
 */
export function createPlayer(advance, ended) {
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  const player = {
    playing: false,
    speed: 1,
    play() {
      player.playing = true;
      beat();
    },
    pause() {
      player.playing = false;
      clearTimeout(timer);
    },
  };

  function beat() {
    timer = setTimeout(() => {
      const isMore = advance();
      if (!player.playing) return;
      if (isMore) return beat();
      player.pause();
      ended();
    }, BEAT / player.speed);
  }

  return player;
}
