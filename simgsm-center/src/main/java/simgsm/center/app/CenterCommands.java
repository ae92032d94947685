package simgsm.center.app;

import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Stream;
import simgsm.center.msc.Exchange;
import simgsm.center.smsc.MessageHistory;
import simgsm.center.smsc.MessageState;
import simgsm.console.CommandException;
import simgsm.console.CommandTable;
import simgsm.console.Console;
import simgsm.console.ConsoleCommand;
import simgsm.console.Event;

/** The centre's console commands. */
public final class CenterCommands implements Console.Commands {
    /** All commands, for the console and for the reference. */
    public static final CommandTable<CenterCommands> COMMANDS = new CommandTable<CenterCommands>(
                    CenterCommands.class.getResourceAsStream("commands.txt"))
            .add(
                    "subscribers",
                    (to, command) -> to.list(
                            command,
                            exchange -> exchange.subscribers().stream()
                                    .map(exchange::row)
                                    .map(Event::from)))
            .add(
                    "calls",
                    (to, command) -> to.list(
                            command, exchange -> exchange.calls().stream().map(Event::from)))
            .add(
                    "messages",
                    (to, command) -> to.list(
                            command,
                            exchange -> exchange.shortMessages().messages().waiting().stream()
                                    .map(message -> Event.from(message, Map.of("state", MessageState.ACCEPTED)))))
            .add("message", CenterCommands::message)
            .add("broadcast", (to, command) -> to.broadcasts.perform(command))
            .add(
                    "broadcasts",
                    (to, command) -> to.list(
                            command, exchange -> exchange.broadcasts().stream().map(Event::from)))
            .add("class", (to, command) -> to.console.emitList("class", to.center.classRows()))
            .add("handover", CenterCommands::handover);

    private final Center center;
    private final Console console;
    private final BroadcastCommand broadcasts;

    public CenterCommands(Center center, Console console) {
        this.center = center;
        this.console = console;
        this.broadcasts = new BroadcastCommand(center, console);
    }

    @Override
    public void perform(ConsoleCommand command) throws CommandException {
        COMMANDS.performAsking(this, command);
    }

    private void list(ConsoleCommand command, Function<Exchange, Stream<Event>> question) {
        List<Event> rows = center.ask(exchange -> question.apply(exchange).toList());
        console.emitList(command.name(), rows);
    }

    private void handover(ConsoleCommand command) throws CommandException {
        String text = command.words(1, "handover ALGORITHM[,NAME=N]...").get(0);
        try {
            console.emit(center.setHandover(text));
        } catch (IllegalArgumentException e) {
            throw new CommandException("handover: " + e.getMessage());
        }
    }

    /** Prints the history of one message. */
    private void message(ConsoleCommand command) throws CommandException {
        String id = command.words(1, "message ID").get(0);
        if (!id.matches("[0-9]{1,18}")) {
            throw new CommandException("message: expected an id as messages lists it, found " + id);
        }
        MessageHistory history = center.ask(
                        exchange -> exchange.shortMessages().messages().history(Long.parseLong(id)))
                .orElseThrow(() ->
                        new CommandException("message: expected one that waits or has lately ended, found " + id));
        console.emit(Event.from(history));
        console.emitList("message", history.attempts().stream().map(Event::from).toList());
    }
}
