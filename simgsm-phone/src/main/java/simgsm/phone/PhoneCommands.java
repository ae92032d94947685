package simgsm.phone;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import simgsm.air.Msisdn;
import simgsm.audio.SoundFile;
import simgsm.console.CommandException;
import simgsm.console.CommandTable;
import simgsm.console.Console;
import simgsm.console.ConsoleCommand;
import simgsm.console.Event;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.handset.Handset;
import simgsm.phone.handset.Refusal;
import simgsm.phone.handset.UserCodes;
import simgsm.phone.store.StoredMessage;
import simgsm.sim.CardPin;
import simgsm.sms.ChannelList;
import simgsm.ss.ServiceCode;
import simgsm.ss.UssdText;

/** The console's commands. Each ends on the owner thread before the next is read, so errors are in order. */
final class PhoneCommands implements Console.Commands {
    static final CommandTable<PhoneCommands> TABLE = new CommandTable<PhoneCommands>(
                    PhoneCommands.class.getResourceAsStream("commands.txt"))
            .add("dial", PhoneCommands::dial)
            .add("answer", (phone, command) -> phone.perform(command, Handset::answer))
            .add("hangup", (phone, command) -> phone.perform(command, Handset::hangUp))
            .add("hold", (phone, command) -> phone.perform(command, Handset::hold))
            .add("reject", (phone, command) -> phone.perform(command, Handset::rejectSecond))
            .add("press", PhoneCommands::press)
            .add("play", PhoneCommands::play)
            .add("sms", PhoneCommands::sms)
            .add("ussd", PhoneCommands::ussd)
            .add("pin", PhoneCommands::pin)
            .add("puk", PhoneCommands::puk)
            .add("name", PhoneCommands::name)
            .add("inbox", (phone, command) -> phone.inbox())
            .add("channels", PhoneCommands::channels)
            .add("memory", PhoneCommands::memory)
            .add("power", PhoneCommands::power);

    /** Time allowed at the program's end for acknowledgements, besides the time for queued keys. */
    private static final long SETTLE_SECONDS = 10;
    /** Time allowed per queued key, which takes 100 ms of tone and 100 ms of pause, or two answers of the network. */
    private static final long KEY_NANOS = TimeUnit.MILLISECONDS.toNanos(400);

    private final Console console;
    private final HandsetAccess phone;
    private long keysPressed;

    PhoneCommands(Console console, HandsetAccess phone) {
        this.console = console;
        this.phone = phone;
    }

    @Override
    public void perform(ConsoleCommand command) throws CommandException {
        TABLE.perform(this, command);
    }

    /** Waits until queued keys are sent and messages acknowledged; fails the run at the time-out. */
    void finish() throws InterruptedException {
        if (!phone.settle(TimeUnit.SECONDS.toNanos(SETTLE_SECONDS) + keysPressed * KEY_NANOS)) {
            console.fail();
        }
    }

    private void dial(ConsoleCommand command) throws CommandException {
        String typed = command.words(1, "dial NUMBER").get(0);
        if (!ServiceCode.isCode(typed)) {
            number(command, ServiceCode.called(typed));
        }
        perform(command, handset -> handset.codes().perform(typed));
    }

    private void press(ConsoleCommand command) throws CommandException {
        List<DtmfKey> keys = parsed(command, () -> DtmfKey.sequence(command.rest()));
        if (keys.isEmpty()) {
            throw new CommandException("press: expected press KEYS, found nothing after it");
        }
        perform(command, handset -> handset.press(keys));
        keysPressed += keys.size();
    }

    private void play(ConsoleCommand command) throws CommandException {
        String file = command.words(1, "play FILE.wav").get(0);
        short[] samples;
        try {
            samples = SoundFile.read(Path.of(file));
        } catch (IOException | IllegalArgumentException e) {
            throw new CommandException("play: " + file + ": " + e.getMessage());
        }
        perform(command, handset -> handset.play(samples));
    }

    private void sms(ConsoleCommand command) throws CommandException {
        ConsoleCommand tail = command.tail();
        if (tail.name().isEmpty()) {
            throw new CommandException("sms: expected sms NUMBER TEXT, found nothing after it");
        }
        Msisdn to = number(command, tail.name());
        if (tail.rest().isEmpty()) {
            throw new CommandException("sms: expected sms NUMBER TEXT, found no text");
        }
        String text;
        try {
            text = tail.text();
        } catch (CommandException e) {
            throw new CommandException("sms: " + e.getMessage());
        }
        perform(command, handset -> handset.sendMessage(to, text));
    }

    private void ussd(ConsoleCommand command) throws CommandException {
        String text = command.text();
        if (text.isEmpty()) {
            throw new CommandException("ussd: expected ussd CODE, found nothing after it");
        }
        perform(command, handset -> handset.codes().send(text));
    }

    private void pin(ConsoleCommand command) throws CommandException {
        String pin = command.words(1, "pin CODE").get(0);
        check(command, CardPin.isPin(pin), "a PIN of 4 to 8 digits");
        perform(command, handset -> handset.codes().useCard(card -> card.verify(pin)));
    }

    private void puk(ConsoleCommand command) throws CommandException {
        List<String> codes = command.words(2, "puk PUK NEWPIN");
        check(command, CardPin.isPuk(codes.get(0)), "a PUK of 8 digits");
        check(command, CardPin.isPin(codes.get(1)), "a new PIN of 4 to 8 digits");
        perform(command, handset -> handset.codes().useCard(card -> card.unblock(codes.get(0), codes.get(1))));
    }

    /** The error does not repeat what was found, because it may be nearly the code. */
    private static void check(ConsoleCommand command, boolean isValid, String expected) throws CommandException {
        if (!isValid) {
            throw new CommandException(command.name() + ": expected " + expected);
        }
    }

    private void name(ConsoleCommand command) throws CommandException {
        String name = command.text().strip();
        if (name.isEmpty()) {
            throw new CommandException("name: expected name TEXT, found nothing after it");
        }
        if (!UssdText.fits(UserCodes.ofName(name))) {
            throw new CommandException("name: expected at most 74 characters, found " + name.length());
        }
        run(handset -> handset.userCodes().name(name));
    }

    private void inbox() throws CommandException {
        // Printed by the owner thread, so that no message received meanwhile is printed within the list.
        run(handset -> {
            List<StoredMessage> messages = handset.readInbox();
            console.emitList("inbox", messages.stream().map(Event::from).toList());
        });
    }

    private void power(ConsoleCommand command) throws CommandException {
        run(isFirst(command, "on", "off") ? Handset::powerOn : Handset::powerOff);
    }

    private void channels(ConsoleCommand command) throws CommandException {
        ChannelList channels = parsed(command, () -> ChannelList.parse(command.rest()));
        run(handset -> handset.station().setChannels(channels));
    }

    private void memory(ConsoleCommand command) throws CommandException {
        boolean available = !isFirst(command, "full", "free");
        run(handset -> handset.station().setMemoryAvailable(available));
    }

    private static boolean isFirst(ConsoleCommand command, String first, String second) throws CommandException {
        String name = command.name();
        String word = command.words(1, name + " " + first + " or " + name + " " + second)
                .get(0);
        if (!word.equals(first) && !word.equals(second)) {
            throw new CommandException(name + ": expected " + first + " or " + second + ", found " + word);
        }
        return word.equals(first);
    }

    private static Msisdn number(ConsoleCommand command, String text) throws CommandException {
        try {
            return Msisdn.parse(text);
        } catch (IllegalArgumentException e) {
            throw new CommandException(command.name() + ": expected a telephone number of 1 to " + Msisdn.MAX_DIGITS
                    + " digits, found " + text);
        }
    }

    private static <T> T parsed(ConsoleCommand command, Supplier<T> parser) throws CommandException {
        try {
            return parser.get();
        } catch (IllegalArgumentException e) {
            throw new CommandException(command.name() + ": " + e.getMessage());
        }
    }

    private void run(Consumer<Handset> action) throws CommandException {
        ask(handset -> {
            action.accept(handset);
            return Optional.empty();
        });
    }

    private void perform(ConsoleCommand command, Function<Handset, Optional<Refusal>> action) throws CommandException {
        Optional<Refusal> refusal = ask(action);
        if (refusal.isPresent()) {
            throw new CommandException(command.name() + ": " + refusal.get().words());
        }
    }

    private Optional<Refusal> ask(Function<Handset, Optional<Refusal>> action) throws CommandException {
        try {
            return phone.ask(action);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new CommandException("interrupted");
        } catch (IllegalStateException e) {
            throw new CommandException(e.getMessage());
        }
    }
}
