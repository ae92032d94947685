package simrobot.replay;

import simgsm.octets.OctetReader;
import simgsm.octets.OctetWriter;
import simrobot.behaviour.BehaviourKind;
import simrobot.robot.RobotState;
import vericommand.RobotStatus;

/**
 * One robot's states, one after another, as small numbers: of every quantity only how far, in units of its last place, it
 * lies from where its last three values lead. Writer and reader foretell alike, so nothing is lost.
 */
final class Track {
    private static final int QUANTITIES = 8;

    /** The lowest, for it costs an octet more to say of the highest that they have changed. */
    private static final int STATUS_BIT = 1;

    private static final RobotStatus[] STATUSES = RobotStatus.values();
    private static final BehaviourKind[] BEHAVIOURS = BehaviourKind.values();

    /** Each quantity's newest value and the two before it. */
    private final double[] newest = new double[QUANTITIES];

    private final double[] before = new double[QUANTITIES];
    private final double[] beforeThat = new double[QUANTITIES];
    private RobotStatus status = RobotStatus.STOPPED;
    private BehaviourKind behaviour = BehaviourKind.NONE;

    private static double quantity(RobotState state, int i) {
        return switch (i) {
            case 0 -> state.xMeters();
            case 1 -> state.yMeters();
            case 2 -> state.headingRadians();
            case 3 -> state.speedMetersPerSecond();
            case 4 -> state.turnRadiansPerSecond();
            case 5 -> state.odometryXMeters();
            case 6 -> state.odometryYMeters();
            default -> state.odometryHeadingRadians();
        };
    }

    RobotState state() {
        return new RobotState(
                newest[0], newest[1], newest[2], newest[3], newest[4], newest[5], newest[6], newest[7], status,
                behaviour);
    }

    boolean differs(RobotState state) {
        for (int i = 0; i < QUANTITIES; i++) {
            if (bits(quantity(state, i)) != bits(newest[i])) {
                return true;
            }
        }
        return state.status() != status || state.behaviour() != behaviour;
    }

    // ---- whole states --------------------------------------------------------------------------------------------

    void writeWhole(RobotState state, OctetWriter out) {
        for (int i = 0; i < QUANTITIES; i++) {
            begin(i, quantity(state, i));
            out.real(newest[i]);
        }
        takeStatus(state.status(), state.behaviour());
        writeStatus(out);
    }

    void readWhole(OctetReader<DamagedException> in) {
        for (int i = 0; i < QUANTITIES; i++) {
            begin(i, in.real());
        }
        readStatus(in);
    }

    private void begin(int i, double value) {
        newest[i] = value;
        before[i] = value;
        beforeThat[i] = value;
    }

    // ---- changes -------------------------------------------------------------------------------------------------

    void writeChange(RobotState state, OctetWriter out) {
        int mask = 0;
        for (int i = 0; i < QUANTITIES; i++) {
            if (bits(quantity(state, i)) != bits(foretold(i))) {
                mask |= bit(i);
            }
        }
        if (state.status() != status || state.behaviour() != behaviour) {
            mask |= STATUS_BIT;
        }
        out.compact(mask);
        for (int i = 0; i < QUANTITIES; i++) {
            double value = quantity(state, i);
            if ((mask & bit(i)) != 0) {
                out.compactSigned(bits(value) - bits(foretold(i)));
            }
            advance(i, value);
        }
        takeStatus(state.status(), state.behaviour());
        if ((mask & STATUS_BIT) != 0) {
            writeStatus(out);
        }
    }

    void readChange(OctetReader<DamagedException> in) {
        long mask = in.compact();
        for (int i = 0; i < QUANTITIES; i++) {
            double foretold = foretold(i);
            advance(i, (mask & bit(i)) == 0 ? foretold : value(bits(foretold) + in.compactSigned()));
        }
        if ((mask & STATUS_BIT) != 0) {
            readStatus(in);
        }
    }

    private static int bit(int i) {
        return STATUS_BIT << 1 + i;
    }

    /** Where constant acceleration leads; what stands stays. */
    private double foretold(int i) {
        double step = newest[i] - before[i];
        return newest[i] + (step + (step - (before[i] - beforeThat[i])));
    }

    private void advance(int i, double value) {
        beforeThat[i] = before[i];
        before[i] = newest[i];
        newest[i] = value;
    }

    /** The bits in an order in which neighbours are neighbours, across 0 too; its own inverse. */
    private static long ordered(long bits) {
        return bits < 0 ? bits ^ Long.MAX_VALUE : bits;
    }

    private static long bits(double value) {
        return ordered(Double.doubleToRawLongBits(value));
    }

    private static double value(long bits) {
        return Double.longBitsToDouble(ordered(bits));
    }

    private void takeStatus(RobotStatus now, BehaviourKind process) {
        status = now;
        behaviour = process;
    }

    private void writeStatus(OctetWriter out) {
        out.octet(status.ordinal()).octet(behaviour.ordinal());
    }

    private void readStatus(OctetReader<DamagedException> in) {
        int s = in.octet("a status");
        int b = in.octet("a process");
        if (s >= STATUSES.length || b >= BEHAVIOURS.length) {
            throw new DamagedException("a robot's status " + s + " with the process " + b);
        }
        takeStatus(STATUSES[s], BEHAVIOURS[b]);
    }
}
