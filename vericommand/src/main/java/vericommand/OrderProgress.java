package vericommand;

/**
 * Progress of an order.
 *
 * @param amountDone of the current motion, in its own unit
 * @param number of the current instruction, from 1
 * @param of number of instructions
 */
record OrderProgress(Instruction instruction, double amountDone, int number, int of) {
    /** {@code 12 of 20 cm}, rounded to whole units. */
    String amounts(ReplyTexts texts) {
        if (!(instruction instanceof Instruction.Motion motion)) {
            return instruction.keys();
        }
        String unit = motion instanceof Instruction.Forward ? "amounts.centimeters" : "amounts.degrees";
        long whole = Math.min(Math.round(amountDone), motion.amount());
        return texts.text(unit, "" + whole, "" + motion.amount());
    }

    /** {@code instruction 2 of 3}. */
    String place(ReplyTexts texts) {
        return texts.text("reply.place", "" + number, "" + of);
    }
}
