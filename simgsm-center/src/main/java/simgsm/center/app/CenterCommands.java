package simgsm.center.app;

import java.util.List;
import java.util.function.Function;
import simgsm.center.msc.Exchange;
import simgsm.center.smsc.MessageHistory;
import simgsm.console.CommandException;
import simgsm.console.Console;
import simgsm.console.ConsoleCommand;
import simgsm.console.Event;

/** The centre's console commands. */
public final class CenterCommands implements Console.Commands {
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
        switch (command.name()) {
            case "subscribers" ->
                list(
                        command,
                        exchange -> exchange.subscribers().stream()
                                .map(subscriber -> CenterEventPrinter.of(subscriber, exchange.isBarred(subscriber)))
                                .toList());
            case "calls" ->
                list(
                        command,
                        exchange -> exchange.calls().stream()
                                .map(CenterEventPrinter::of)
                                .toList());
            case "messages" ->
                list(
                        command,
                        exchange -> exchange.shortMessages().waiting().stream()
                                .map(CenterEventPrinter::of)
                                .toList());
            case "message" -> message(command);
            case "broadcast" -> broadcasts.perform(command);
            case "broadcasts" ->
                list(
                        command,
                        exchange -> exchange.broadcasts().stream()
                                .map(CenterEventPrinter::of)
                                .toList());
            default ->
                throw new CommandException("unknown command " + command.name()
                        + ", expected subscribers, calls, messages, message, broadcast, broadcasts, wait or quit");
        }
    }

    private void list(ConsoleCommand command, Function<Exchange, List<Event>> question) throws CommandException {
        command.words(0, "nothing after it");
        List<Event> rows = center.ask(question);
        rows.forEach(console::emit);
        console.emit(CenterEventPrinter.end(command.name(), rows.size()));
    }

    /** What has happened to one message. */
    private void message(ConsoleCommand command) throws CommandException {
        String id = command.words(1, "message ID").get(0);
        if (!id.matches("[0-9]{1,18}")) {
            throw new CommandException("message: expected an id as messages lists it, found " + id);
        }
        MessageHistory history = center.ask(exchange -> exchange.shortMessages().history(Long.parseLong(id)))
                .orElseThrow(() ->
                        new CommandException("message: expected one that waits or has lately ended, found " + id));
        console.emit(CenterEventPrinter.of(history));
        history.attempts().stream().map(CenterEventPrinter::of).forEach(console::emit);
        console.emit(CenterEventPrinter.end("message", history.attempts().size()));
    }
}
