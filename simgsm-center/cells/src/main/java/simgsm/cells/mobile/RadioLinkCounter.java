package simgsm.cells.mobile;

/** Counts blocks of the slow associated channel (TS 45.008, 5.2): 2 up for a good one, 1 down for a lost one. */
final class RadioLinkCounter {
    private static final int GOOD = 2;

    private final int most;
    private int count;

    /** @param timeout RADIO_LINK_TIMEOUT, 4 to 64 */
    RadioLinkCounter(int timeout) {
        most = timeout;
        count = timeout;
    }

    /** @return true if the link has failed */
    boolean block(boolean isGood) {
        count = isGood ? Math.min(most, count + GOOD) : Math.max(0, count - 1);
        return count == 0;
    }

    int count() {
        return count;
    }
}
