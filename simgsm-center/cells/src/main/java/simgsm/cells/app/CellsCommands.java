package simgsm.cells.app;

import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;
import simgsm.cells.net.CellsLoop;
import simgsm.cells.network.CellNetwork;
import simgsm.cells.snapshot.HandoverRule;
import simgsm.cells.tower.BaseStation;
import simgsm.cells.town.TownPlace;
import simgsm.console.CommandException;
import simgsm.console.CommandTable;
import simgsm.console.Console;
import simgsm.console.ConsoleCommand;
import simgsm.console.Event;

/** The console commands of the cells. */
public final class CellsCommands implements Console.Commands {
    /** All commands, for the console and for the reference. */
    public static final CommandTable<CellsCommands> COMMANDS = new CommandTable<CellsCommands>(
                    CellsCommands.class.getResourceAsStream("commands.txt"))
            .add("cells", (to, command) -> to.list(command, network -> network.towers().stream()))
            .add(
                    "mobiles",
                    (to, command) -> to.list(
                            command,
                            network -> network.mobiles().stream().map(mobile -> MobileRow.of(mobile, network))))
            .add("place", CellsCommands::place)
            .add("walk", CellsCommands::walk)
            .add("tower", CellsCommands::tower)
            .add("reports", CellsCommands::reports)
            .add("handover", CellsCommands::handover);

    private static final double FASTEST_METRES_PER_SECOND = 1_000;
    private static final double FARTHEST_METRES = 1e6;

    private final CellsLoop cells;
    private final Console console;
    private final CellsEvents events;

    public CellsCommands(CellsLoop cells, Console console, CellsEvents events) {
        this.cells = cells;
        this.console = console;
        this.events = events;
    }

    @Override
    public void perform(ConsoleCommand command) throws CommandException {
        COMMANDS.performAsking(this, command);
    }

    private void list(ConsoleCommand command, Function<CellNetwork, Stream<?>> question) {
        List<Event> rows =
                cells.ask(network -> question.apply(network).map(Event::from).toList());
        console.emitList(command.name(), rows);
    }

    private void place(ConsoleCommand command) throws CommandException {
        List<String> words = command.words(3, "place NUMBER X Y");
        TownPlace place = place(command, words);
        cells.ask(network -> {
            network.place(words.get(0), place);
            return true;
        });
    }

    private void walk(ConsoleCommand command) throws CommandException {
        List<String> words = command.words(4, "walk NUMBER X Y METRES_PER_SECOND");
        TownPlace place = place(command, words);
        double speed = command.number(words.get(3), 0, FASTEST_METRES_PER_SECOND);
        boolean isThere = cells.ask(network -> network.walk(words.get(0), List.of(place), speed));
        if (!isThere) {
            throw new CommandException(
                    "walk: expected the number of a phone or robot that is connected, found " + words.get(0));
        }
    }

    private static TownPlace place(ConsoleCommand command, List<String> words) throws CommandException {
        return new TownPlace(
                command.number(words.get(1), -FARTHEST_METRES, FARTHEST_METRES),
                command.number(words.get(2), -FARTHEST_METRES, FARTHEST_METRES));
    }

    private void tower(ConsoleCommand command) throws CommandException {
        List<String> words = command.words(2, "tower NAME on|off");
        boolean on = isOn(command, words.get(1));
        boolean isThere = cells.ask(network -> {
            var found = network.tower(words.get(0));
            found.ifPresent((BaseStation tower) -> cells.switchTower(tower, on));
            return found.isPresent();
        });
        if (!isThere) {
            throw new CommandException("tower: expected the name of a tower as cells lists it, found " + words.get(0));
        }
    }

    private void reports(ConsoleCommand command) throws CommandException {
        events.showReports(isOn(command, command.words(1, "reports on|off").get(0)));
    }

    private void handover(ConsoleCommand command) throws CommandException {
        try {
            HandoverRule rule = HandoverRule.parse(
                    command.words(1, "handover ALGORITHM[,NAME=N]...").get(0));
            cells.post(network -> network.setHandoverRule(rule));
        } catch (IllegalArgumentException e) {
            throw new CommandException("handover: " + e.getMessage());
        }
    }

    private static boolean isOn(ConsoleCommand command, String word) throws CommandException {
        if (!word.equals("on") && !word.equals("off")) {
            throw new CommandException(command.name() + ": expected on or off, found " + word);
        }
        return word.equals("on");
    }
}
