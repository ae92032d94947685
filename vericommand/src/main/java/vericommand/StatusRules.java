package vericommand;

/** The paper's check before every command: the instructions permitted in each status. */
public final class StatusRules {
    /** Treatment of an instruction, and its tone. */
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

    private StatusRules() {}

    public static Treatment treatment(RobotStatus status, Instruction instruction) {
        return switch (status) {
            case COLLISION -> isPossibleInCollision(instruction) ? Treatment.EXECUTED : Treatment.REFUSED;
            case MOVING -> Order.moves(instruction) ? Treatment.BUSY : Treatment.EXECUTED;
            case STOPPED -> Treatment.EXECUTED;
            case NO_MOTORS -> instruction instanceof Instruction.ReportStatus ? Treatment.EXECUTED : Treatment.REFUSED;
            case DISCONNECTED -> Treatment.DENIED;
        };
    }

    private static boolean isPossibleInCollision(Instruction instruction) {
        return !(instruction instanceof Instruction.Forward || instruction instanceof Instruction.StartProcess);
    }
}
