package simgsm.cells.tower;

/** TDMA frames (TS 45.002): numbers and times since the start, equal for all towers. */
public final class FrameClock {
    /** 26 frames in 120 ms. */
    private static final long MULTIFRAME_NANOS = 120_000_000;

    private static final int FRAMES = 26;
    /** Number of frames of a multiframe of the common channels. */
    private static final int COMMON_FRAMES = 51;

    private FrameClock() {}

    public static long frameAt(long nanos) {
        return nanos * FRAMES / MULTIFRAME_NANOS;
    }

    /** The duration of a number of frames, which are also the slots of random access. */
    public static long nanos(long frames) {
        return frames * MULTIFRAME_NANOS / FRAMES;
    }

    /** The time until the next multiframe of the common channels. */
    static long untilMultiframeNanos(long nowNanos) {
        return nanos(COMMON_FRAMES - frameAt(nowNanos) % COMMON_FRAMES);
    }

    /**
     * The time until the end of a paging group's next block.
     *
     * @param blocks paging blocks in a multiframe;
     * @param multiframes BS_PA_MFRMS
     */
    static long untilPagingNanos(long nowNanos, int group, int blocks, int multiframes) {
        long period = (long) COMMON_FRAMES * multiframes;
        // blocks of four frames follow the BCCH's, which end with frame 5; two frames separate pairs of them
        int block = group % blocks;
        long end = (long) group / blocks % multiframes * COMMON_FRAMES + 10 + 4L * block + block / 2 * 2L;
        long wait = Math.floorMod(end - frameAt(nowNanos), period);
        return nanos(wait);
    }
}
