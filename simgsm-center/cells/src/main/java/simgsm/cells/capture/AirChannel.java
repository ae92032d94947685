package simgsm.cells.capture;

import simgsm.air.ChannelNumber;

/**
 * The place of a logical channel's blocks in the multiframes (TS 45.002, 7, table 1).
 *
 * @param type of GSMTAP
 * @param start frame of the first burst of a downlink block, modulo the period
 * @param uplinkDelay frames from there to that of an uplink block
 * @param step frames from burst to burst
 * @param bursts 4, or 8 that are half used
 */
record AirChannel(int type, int timeslot, int subslot, int period, int start, int uplinkDelay, int step, int bursts) {
    static final int BCCH = 1;
    static final int RACH = 3;
    static final int AGCH = 4;
    static final int PCH = 5;
    static final int SDCCH_4 = 7;
    static final int SDCCH_8 = 8;
    static final int TCH_F = 9;
    static final int TCH_H = 10;
    /** Flag of a slow associated channel. */
    static final int SLOW = 0x80;

    private static final int MULTIFRAME = 51;
    private static final int[] SDCCH_4_STARTS = {22, 26, 32, 36};
    private static final int[] SACCH_4_STARTS = {42, 46, 93, 97};
    private static final int UPLINK_DELAY = 15;

    /** A block of the common channels. @param start of the block in the multiframe */
    static AirChannel common(int type, int start) {
        return new AirChannel(type, 0, 0, MULTIFRAME, start, 0, 1, 4);
    }

    /** The start of a paging or access grant block in the multiframe: pairs of blocks after FCCH and SCH. */
    static int commonStart(int block) {
        return 6 + 4 * block + 2 * ((block + 1) / 2);
    }

    static AirChannel main(ChannelNumber number) {
        int sub = number.subchannel();
        return switch (number.kind()) {
            case SDCCH_4 -> signalling(SDCCH_4, number, MULTIFRAME, SDCCH_4_STARTS[sub]);
            case SDCCH_8 -> signalling(SDCCH_8, number, MULTIFRAME, 4 * sub);
            // blocks begin with frames 0, 4 and 8 of 13; the first of them is used
            default -> new AirChannel(type(number), number.timeslot(), sub, 13, 0, 0, 1, 8);
        };
    }

    static AirChannel slow(ChannelNumber number) {
        int sub = number.subchannel();
        return switch (number.kind()) {
            case SDCCH_4 -> signalling(SDCCH_4 | SLOW, number, 2 * MULTIFRAME, SACCH_4_STARTS[sub]);
            case SDCCH_8 ->
                signalling(SDCCH_8 | SLOW, number, 2 * MULTIFRAME, 32 + 4 * (sub % 4) + MULTIFRAME * (sub / 4));
            default ->
                new AirChannel(
                        type(number) | SLOW,
                        number.timeslot(),
                        sub,
                        104,
                        (12 + 13 * number.timeslot()) % 104,
                        0,
                        26,
                        4);
        };
    }

    private static AirChannel signalling(int type, ChannelNumber number, int period, int start) {
        return new AirChannel(type, number.timeslot(), number.subchannel(), period, start, UPLINK_DELAY, 1, 4);
    }

    private static int type(ChannelNumber number) {
        return number.kind() == ChannelNumber.Kind.TCH_F ? TCH_F : TCH_H;
    }

    /** The first frame of the next block, not before a frame. */
    long next(long from, boolean isUplink) {
        return from + Math.floorMod(start + (isUplink ? uplinkDelay : 0) - from, (long) period);
    }
}
