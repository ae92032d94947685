package simgsm.phone;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import simgsm.air.Msisdn;
import simgsm.console.CommandException;
import simgsm.console.Console;
import simgsm.console.ConsoleCommand;
import simgsm.console.Event;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.handset.Handset;
import simgsm.phone.handset.Refusal;
import simgsm.phone.handset.StoredMessage;
import simgsm.sms.ChannelList;

/** The console's commands. Each is done by the owner thread before the next is read, so errors stand in their order. */
final class PhoneCommands implements Console.Commands {
    /** So long the end waits for acknowledgements. */
    private static final long PATIENCE_SECONDS = 10;
    /** A queued key takes 100 ms of tone and 100 ms of pause, or two answers of the network. */
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
        switch (command.name()) {
            case "dial" -> dial(command);
            case "answer" -> plain(command, Handset::answer);
            case "hangup" -> plain(command, Handset::hangUp);
            case "press" -> press(command);
            case "sms" -> sms(command);
            case "inbox" -> inbox(command);
            case "channels" -> channels(command);
            case "memory" -> memory(command);
            case "power" -> power(command);
            default ->
                throw new CommandException("unknown command " + command.name()
                        + ", expected dial, answer, hangup, press, sms, inbox, channels, memory, wait, power or quit");
        }
    }

    /** Ends what was begun: queued keys leave, messages are acknowledged, but not for longer than is reasonable. */
    void finish() throws InterruptedException {
        phone.settle(TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS) + keysPressed * KEY_NANOS);
    }

    private void dial(ConsoleCommand command) throws CommandException {
        Msisdn number = number("dial", command.words(1, "dial NUMBER").get(0));
        act("dial", handset -> handset.dial(number));
    }

    private void plain(ConsoleCommand command, Function<Handset, Optional<Refusal>> act) throws CommandException {
        command.words(0, command.name() + " and nothing after it");
        act(command.name(), act);
    }

    private void press(ConsoleCommand command) throws CommandException {
        List<DtmfKey> keys;
        try {
            keys = DtmfKey.sequence(command.rest());
        } catch (IllegalArgumentException e) {
            throw new CommandException("press: " + e.getMessage());
        }
        if (keys.isEmpty()) {
            throw new CommandException("press: expected press KEYS, found nothing after it");
        }
        act("press", handset -> handset.press(keys));
        keysPressed += keys.size();
    }

    private void sms(ConsoleCommand command) throws CommandException {
        ConsoleCommand tail = command.tail();
        if (tail.name().isEmpty()) {
            throw new CommandException("sms: expected sms NUMBER TEXT, found nothing after it");
        }
        Msisdn to = number("sms", tail.name());
        if (tail.rest().isEmpty()) {
            throw new CommandException("sms: expected sms NUMBER TEXT, found no text");
        }
        String text;
        try {
            text = tail.text();
        } catch (CommandException e) {
            throw new CommandException("sms: " + e.getMessage());
        }
        act("sms", handset -> handset.sendMessage(to, text));
    }

    private void inbox(ConsoleCommand command) throws CommandException {
        command.words(0, "inbox and nothing after it");
        // Printed by the owner thread, so that a message that comes meanwhile does not stand in the list's middle.
        ask(handset -> {
            List<StoredMessage> messages = handset.readInbox();
            for (StoredMessage message : messages) {
                console.emit(Event.of("message")
                        .with("from", message.party())
                        .with("text", message.text())
                        .with("read", message.read()));
            }
            console.emit(Event.of("end").with("of", "inbox").with("count", messages.size()));
            return Optional.empty();
        });
    }

    private void power(ConsoleCommand command) throws CommandException {
        String state = command.words(1, "power on or power off").get(0);
        switch (state) {
            case "on" -> run(Handset::powerOn);
            case "off" -> run(Handset::powerOff);
            default -> throw new CommandException("power: expected on or off, found " + state);
        }
    }

    private void channels(ConsoleCommand command) throws CommandException {
        ChannelList channels;
        try {
            channels = ChannelList.parse(command.rest());
        } catch (IllegalArgumentException e) {
            throw new CommandException("channels: " + e.getMessage());
        }
        run(handset -> handset.wantBroadcasts(channels));
    }

    /** For who wants to see what the network does with a phone that has no room. */
    private void memory(ConsoleCommand command) throws CommandException {
        String state = command.words(1, "memory full or memory free").get(0);
        if (!state.equals("full") && !state.equals("free")) {
            throw new CommandException("memory: expected full or free, found " + state);
        }
        run(handset -> handset.memory(state.equals("free")));
    }

    private static Msisdn number(String command, String text) throws CommandException {
        try {
            return Msisdn.parse(text);
        } catch (IllegalArgumentException e) {
            throw new CommandException(
                    command + ": expected a telephone number of 1 to " + Msisdn.MAX_DIGITS + " digits, found " + text);
        }
    }

    private void run(java.util.function.Consumer<Handset> act) throws CommandException {
        ask(handset -> {
            act.accept(handset);
            return Optional.empty();
        });
    }

    private void act(String name, Function<Handset, Optional<Refusal>> act) throws CommandException {
        Optional<Refusal> refusal = ask(act);
        if (refusal.isPresent()) {
            throw new CommandException(name + ": " + refusal.get().words());
        }
    }

    private Optional<Refusal> ask(Function<Handset, Optional<Refusal>> act) throws CommandException {
        try {
            return phone.ask(act);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new CommandException("interrupted");
        } catch (IllegalStateException e) {
            throw new CommandException(e.getMessage());
        }
    }
}
