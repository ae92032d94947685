package vericommand;

import java.util.ArrayList;
import java.util.List;
import simgsm.state.StateMachine;
import vericommand.CommandGrammar.GrammarAction;
import vericommand.CommandGrammar.KeyClass;
import vericommand.CommandGrammar.Place;

/**
 * Reads orders from keys, one key at a time, by the table of {@link CommandGrammar}. A broken order is reported once, at
 * the offending key.
 */
public final class CommandRecognizer {
    /** 10 s of speech at 8 kHz. */
    public static final long TIMEOUT_SAMPLES = 80_000;

    private static final int MAX_DIGITS = 4;
    /** Least number of keys before an opening, {@code #} among them, that count as an order with a lost opening. */
    private static final int LEAST_STRAYS = 3;

    private StateMachine<Place, KeyClass, GrammarAction> machine;
    private final StringBuilder keys = new StringBuilder();
    private final List<Instruction> instructions = new ArrayList<>();
    private int digits;
    private int number;
    private Recognition recognition;
    private long silentSamples;
    /** Keys outside orders since the last order or answer. */
    private final StringBuilder strays = new StringBuilder();
    /** True if the keys outside orders are the rest of a broken order, which has been answered. */
    private boolean isAnswered;

    public CommandRecognizer() {
        reset();
    }

    /** Drops all keys read so far, as at the end of a call. */
    public void reset() {
        machine = new StateMachine<>(CommandGrammar.TABLE, "vericommand", this::perform);
        keys.setLength(0);
        strays.setLength(0);
        isAnswered = false;
        silentSamples = 0;
    }

    /** True from the second star of an order's opening to the last key before its closing star. */
    public boolean isOpen() {
        return CommandGrammar.OPEN.contains(machine.state());
    }

    /** The keys of the open order; empty if none is open. */
    public String keys() {
        return isOpen() ? keys.toString() : "";
    }

    /** Reads the next key; a character that is no telephone key never fits. */
    public Recognition key(char key) {
        silentSamples = 0;
        if (!isOpen() && !isAnswered) {
            strays.append(key);
        }
        keys.append(key);
        recognition = Recognition.PENDING;
        KeyClass event = KeyClass.of(key);
        if (isOpen() && (exceedsLimit(event) || !machine.accepts(event))) {
            recognition = new Recognition.Broken(fault(event, keys.length(), false));
            machine.fire(KeyClass.FAULT);
        }
        machine.fire(event);
        if (!isOpen() && machine.state() != Place.FIRST_STAR) {
            keys.setLength(0);
        }
        if (recognition != Recognition.PENDING || isOpen() && machine.state() != Place.OPENED) {
            strays.setLength(0);
            isAnswered = recognition instanceof Recognition.Broken;
        }
        return recognition;
    }

    /**
     * Counts samples of speech without a key. After 10 s an order that has a key after its opening is dropped, and keys that look
     * like an order without its opening are a fault at the first of them.
     */
    public Recognition elapsed(long samples) {
        silentSamples += samples;
        if (silentSamples < TIMEOUT_SAMPLES) {
            return Recognition.PENDING;
        }
        isAnswered = false;
        if (!machine.accepts(KeyClass.TIMEOUT) || !isOpen()) {
            return strayOrder();
        }
        recognition = new Recognition.Broken(fault(KeyClass.TIMEOUT, keys.length() + 1, true));
        machine.fire(KeyClass.TIMEOUT);
        return recognition;
    }

    private Recognition strayOrder() {
        if (machine.accepts(KeyClass.TIMEOUT)) {
            machine.fire(KeyClass.TIMEOUT);
        }
        String read = strays.toString();
        strays.setLength(0);
        return read.length() < LEAST_STRAYS || read.indexOf('#') < 0
                ? Recognition.PENDING
                : new Recognition.Broken(new OrderFault(read, 1, ExpectedKeys.OPENING, OrderFault.Limit.NONE, true));
    }

    /** The fault of an order that ends here: which key is missing. */
    OrderFault missing() {
        return fault(KeyClass.TIMEOUT, keys.length() + 1, false);
    }

    private OrderFault fault(KeyClass key, int position, boolean timedOut) {
        Place place = machine.state();
        ExpectedKeys expected = digits == MAX_DIGITS ? ExpectedKeys.HASH_OR_STAR : place.expected();
        OrderFault.Limit limit = OrderFault.Limit.NONE;
        if (isFifthDigit(key)) {
            limit = place.range();
        } else if (place.range() != OrderFault.Limit.NONE && !numberIsInRange()) {
            expected = ExpectedKeys.NUMBER;
            limit = place.range();
        } else if (exceedsInstructions(key)) {
            expected = ExpectedKeys.CLOSING;
            limit = OrderFault.Limit.INSTRUCTIONS;
        }
        return new OrderFault(keys.toString(), position, expected, limit, timedOut);
    }

    private boolean exceedsLimit(KeyClass key) {
        return isFifthDigit(key)
                || digits > 0 && !CommandGrammar.DIGITS.contains(key) && !numberIsInRange()
                || exceedsInstructions(key);
    }

    private boolean isFifthDigit(KeyClass key) {
        return digits == MAX_DIGITS && CommandGrammar.DIGITS.contains(key);
    }

    private boolean numberIsInRange() {
        return number >= 1 && number <= machine.state().range().max();
    }

    private boolean exceedsInstructions(KeyClass key) {
        int begun = instructions.size() + (digits > 0 ? 1 : 0);
        return key == KeyClass.HASH && machine.accepts(key) && begun == Order.MAX_INSTRUCTIONS;
    }

    private void perform(GrammarAction action) {
        switch (action) {
            case OPEN_ORDER -> {
                keys.replace(0, keys.length(), "**");
                instructions.clear();
                clearNumber();
            }
            case ADD_DIGIT -> {
                digits++;
                number = 10 * number + digit();
            }
            case ADD_FORWARD -> addNumbered(new Instruction.Forward(number));
            case ADD_TURN -> addNumbered(new Instruction.Turn(number));
            case ADD_STOP -> instructions.add(new Instruction.StopNow());
            case ADD_REPORT -> instructions.add(new Instruction.ReportStatus());
            case ADD_PROCESS -> instructions.add(new Instruction.StartProcess(digit()));
            case ADD_PROCESS_DIGIT -> {
                Instruction.StartProcess begun =
                        (Instruction.StartProcess) instructions.remove(instructions.size() - 1);
                instructions.add(new Instruction.StartProcess(10 * begun.number() + digit()));
            }
            case COMPLETE_ORDER -> recognition = new Recognition.Complete(new Order(keys.toString(), instructions));
        }
    }

    private int digit() {
        return keys.charAt(keys.length() - 1) - '0';
    }

    private void addNumbered(Instruction instruction) {
        instructions.add(instruction);
        clearNumber();
    }

    private void clearNumber() {
        digits = 0;
        number = 0;
    }
}
