package vericommand;

/**
 * How far an order got: within its present motion, and which instruction that is.
 *
 * @param number of the instruction, from 1
 * @param of how many instructions
 */
record OrderProgress(Instruction.Motion motion, double amountDone, int number, int of) {
    /** {@code 12 of 20 cm}; rounded to whole units as the operator keyed them. */
    String amounts(ReplyTexts texts) {
        String unit = motion instanceof Instruction.Forward ? "amounts.centimeters" : "amounts.degrees";
        long whole = Math.min(Math.round(amountDone), motion.amount());
        return texts.text(unit, "" + whole, "" + motion.amount());
    }

    String place(ReplyTexts texts) {
        return texts.text("reply.place", "" + number, "" + of);
    }
}
