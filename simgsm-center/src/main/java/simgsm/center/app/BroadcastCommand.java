package simgsm.center.app;

import java.time.Duration;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simgsm.center.msc.BroadcastOrder;
import simgsm.center.msc.BroadcastView;
import simgsm.console.CommandException;
import simgsm.console.Console;
import simgsm.console.ConsoleCommand;

/**
 * {@code broadcast CHANNEL TEXT}, with optional {@code lang=es every=30 times=10 update=3} before the channel; {@code
 * broadcast stop ID} ends a repeated one.
 */
final class BroadcastCommand {
    private static final Pattern OPTION = Pattern.compile("(lang|every|times|update)=(.*)");
    private static final String EXPECTED = "broadcast: expected CHANNEL TEXT, found ";
    /** The number of times with {@code every=} alone. */
    private static final OptionalInt UNTIL_STOPPED = OptionalInt.empty();

    private final Center center;
    private final Console console;

    /** The options before the channel. */
    private static final class Options {
        Optional<String> language = Optional.empty();
        Duration period = BroadcastOrder.DEFAULT_PERIOD;
        OptionalInt times = OptionalInt.of(1);
        OptionalInt updated = OptionalInt.empty();
        boolean isRepeated;
        boolean isCounted;

        void take(String name, String value) throws CommandException {
            switch (name) {
                case "lang" -> language = Optional.of(language(value));
                case "every" -> {
                    period = Duration.ofSeconds(number(name, value));
                    isRepeated = true;
                }
                case "times" -> {
                    times = OptionalInt.of(number(name, value));
                    isCounted = true;
                }
                default -> updated = OptionalInt.of(number(name, value));
            }
        }

        private static String language(String value) throws CommandException {
            if (!value.matches("[a-z]{2}")) {
                throw new CommandException("broadcast: expected lang= and two letters, found lang=" + value);
            }
            return value;
        }

        private static int number(String name, String value) throws CommandException {
            if (!value.matches("[0-9]{1,6}")) {
                throw new CommandException(
                        "broadcast: expected " + name + "= and a number, found " + name + "=" + value);
            }
            return Integer.parseInt(value);
        }

        BroadcastOrder order(int channel, String text) {
            return new BroadcastOrder(
                    channel, text, language, period, isRepeated && !isCounted ? UNTIL_STOPPED : times, updated);
        }
    }

    BroadcastCommand(Center center, Console console) {
        this.center = center;
        this.console = console;
    }

    void perform(ConsoleCommand command) throws CommandException {
        Options options = new Options();
        ConsoleCommand rest = command.tail();
        for (Matcher option = OPTION.matcher(rest.name()); option.matches(); option = OPTION.matcher(rest.name())) {
            options.take(option.group(1), option.group(2));
            rest = rest.tail();
        }
        if (rest.name().equals("stop") && rest.rest().matches("[0-9]{1,9}")) {
            stop(Integer.parseInt(rest.rest()));
        } else {
            send(command, rest, options);
        }
    }

    private void stop(int id) throws CommandException {
        if (!center.stopBroadcast(id)) {
            throw new CommandException("broadcast stop: no broadcast " + id + " is repeated");
        }
    }

    private void send(ConsoleCommand command, ConsoleCommand channel, Options options) throws CommandException {
        if (!channel.name().matches("[0-9]{1,5}") || channel.rest().isEmpty()) {
            throw new CommandException(EXPECTED + (command.rest().isEmpty() ? "nothing after it" : command.rest()));
        }
        String text = channel.text();
        if (text.isEmpty()) {
            throw new CommandException(EXPECTED + "an empty text");
        }
        try {
            BroadcastView begun = center.broadcast(options.order(Integer.parseInt(channel.name()), text));
            if (begun.left().orElse(1) > 0) {
                console.tell(begun);
            }
        } catch (IllegalArgumentException e) {
            throw new CommandException("broadcast: " + e.getMessage());
        }
    }
}
