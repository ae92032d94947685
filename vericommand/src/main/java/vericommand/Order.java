package vericommand;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * One complete order, valid in grammar and range.
 *
 * @param received all keys as received, without blanks: the ones that positions count
 */
public record Order(String received, List<Instruction> instructions) {
    public static final int MAX_INSTRUCTIONS = 32;

    public Order {
        instructions = List.copyOf(instructions);
        if (instructions.isEmpty() || instructions.size() > MAX_INSTRUCTIONS) {
            throw new IllegalArgumentException(
                    "an order has 1.." + MAX_INSTRUCTIONS + " instructions, not " + instructions.size());
        }
    }

    /** The keys as received, without blanks and without further stars of the opening. */
    public String keys() {
        return received.replaceFirst("^\\*+", "**");
    }

    /** True if an instruction moves the robot. */
    public boolean moves() {
        return instructions.stream().anyMatch(Order::moves);
    }

    static boolean moves(Instruction instruction) {
        return instruction instanceof Instruction.Motion || instruction instanceof Instruction.StartProcess;
    }

    /** The process started at the order's end. */
    public Optional<Instruction.StartProcess> process() {
        return instructions.get(instructions.size() - 1) instanceof Instruction.StartProcess last
                ? Optional.of(last)
                : Optional.empty();
    }

    /** True if an instruction stops the robot. */
    public boolean stops() {
        return instructions.stream().anyMatch(Instruction.StopNow.class::isInstance);
    }

    /** The order with blanks between its instructions: {@code ** #**20 **}. */
    public String text() {
        return "** " + instructionKeys() + " **";
    }

    /** The instructions with blanks between them: {@code #**100 #*#90}. */
    String instructionKeys() {
        return instructions.stream().map(Instruction::keys).collect(Collectors.joining(" "));
    }

    /** The order in words: "forward 20 cm, turn right 90 degrees". */
    public String words(Locale locale) {
        return instructions.stream()
                .map(instruction -> words(locale, instruction))
                .collect(Collectors.joining(", "));
    }

    private static String words(Locale locale, Instruction instruction) {
        if (instruction instanceof Instruction.Forward forward) {
            return VeriCommandTexts.text(locale, "order.forward", "" + forward.centimeters());
        }
        if (instruction instanceof Instruction.Turn turn) {
            return VeriCommandTexts.text(locale, "order.turn", "" + turn.clockwiseDegrees());
        }
        if (instruction instanceof Instruction.StartProcess process) {
            return VeriCommandTexts.text(locale, "order.process", "" + process.number());
        }
        return VeriCommandTexts.text(
                locale, instruction instanceof Instruction.StopNow ? "order.stop" : "order.report");
    }
}
