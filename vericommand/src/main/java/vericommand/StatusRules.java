package vericommand;

import java.util.EnumMap;
import java.util.Map;

/** Which instruction is executed in which status: the paper's check before every command, as a table. */
public final class StatusRules {
    /** How an instruction is treated, and the tone that says so. */
    public enum Treatment {
        EXECUTED(ReplyTone.EXECUTED),
        /** Not possible in this status. */
        REFUSED(ReplyTone.NOT_POSSIBLE),
        /** The robot is executing another order. */
        BUSY(ReplyTone.EXECUTING),
        /** The robot is off. */
        DENIED(ReplyTone.CONNECTION_DENIED);

        private final ReplyTone tone;

        Treatment(ReplyTone tone) {
            this.tone = tone;
        }

        public ReplyTone tone() {
            return tone;
        }
    }

    private record Row(Treatment forward, Treatment turn, Treatment stop, Treatment report) {}

    private static final Map<RobotStatus, Row> ROWS = new EnumMap<>(Map.of(
            RobotStatus.COLLISION,
            new Row(Treatment.REFUSED, Treatment.EXECUTED, Treatment.EXECUTED, Treatment.EXECUTED),
            RobotStatus.MOVING,
            new Row(Treatment.BUSY, Treatment.BUSY, Treatment.EXECUTED, Treatment.EXECUTED),
            RobotStatus.STOPPED,
            new Row(Treatment.EXECUTED, Treatment.EXECUTED, Treatment.EXECUTED, Treatment.EXECUTED),
            RobotStatus.NO_MOTORS,
            new Row(Treatment.REFUSED, Treatment.REFUSED, Treatment.REFUSED, Treatment.EXECUTED),
            RobotStatus.DISCONNECTED,
            new Row(Treatment.DENIED, Treatment.DENIED, Treatment.DENIED, Treatment.DENIED)));

    private StatusRules() {}

    public static Treatment treatment(RobotStatus status, Instruction instruction) {
        Row row = ROWS.get(status);
        if (instruction instanceof Instruction.Forward) {
            return row.forward();
        }
        if (instruction instanceof Instruction.Turn) {
            return row.turn();
        }
        return instruction instanceof Instruction.StopNow ? row.stop() : row.report();
    }
}
