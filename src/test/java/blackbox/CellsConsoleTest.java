package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The console of the cells: lists, places, towers, reports, and robots that are followed. */
class CellsConsoleTest {
    @Test
    void cellsAndMobilesAreListedWithTheirPlacesAndStates() throws Exception {
        try (Scenario town = new Scenario("lists of a town")) {
            town.center();
            RunningProgram cells = town.cells("village.town");
            assertEquals("2", cells.said("ready").field("cells"));
            town.phone(Scenario.PHONE);
            cells.expect("camped", "number", Scenario.PHONE, "cell", "west");
            cells.expect("location-update", "number", Scenario.PHONE, "lac", "1");

            cells.say("cells");
            ConsoleEvent west = cells.expect("cell", "name", "west");
            assertEquals(
                    Set.of("name", "arfcn", "bsic", "lac", "x", "y", "state", "free"),
                    west.fields().keySet());
            assertEquals("100", west.field("arfcn"));
            assertEquals("on", west.field("state"));
            cells.expect("end", "of", "cells", "count", "2");
            cells.say("mobiles");
            ConsoleEvent phone = cells.expect("mobile", "number", Scenario.PHONE);
            assertEquals(
                    Set.of("number", "x", "y", "cell", "rxlev", "state"),
                    phone.fields().keySet());
            cells.expect("end", "of", "mobiles", "count", "1");
            assertEquals(0, cells.quit());
        }
    }

    @Test
    void wrongCommandsAreErrorsAndTheProgramGoesOn() throws Exception {
        try (Scenario town = new Scenario("wrong commands")) {
            town.center();
            RunningProgram cells = town.cells("village.town");
            for (String wrong : new String[] {
                "place",
                "place 1 x 2",
                "walk 5550199 0 0 1",
                "tower south off",
                "tower west maybe",
                "reports",
                "handover best",
                "fly"
            }) {
                String text = cells.ask(wrong, "error").field("text");
                assertTrue(text.startsWith(wrong.equals("fly") ? "unknown" : wrong.split(" ")[0]), text);
            }
            assertEquals(0, cells.quit());
        }
    }

    @Test
    void aPhoneThatWalksAcrossTheRiverUpdatesItsLocation() throws Exception {
        try (Scenario town = new Scenario("two location areas")) {
            town.center();
            RunningProgram cells = town.cells("city.town");
            RunningProgram phone = town.phone(Scenario.PHONE);
            cells.expect("location-update", "number", Scenario.PHONE);
            Set<String> areas = Set.of("1", "2");
            String before = cells.said("location-update").field("lac");
            assertTrue(areas.contains(before), before);

            for (ConsoleEvent cell = cells.ask("cells", "cell"); ; cell = cells.expect("cell")) {
                if (!cell.field("lac").equals(before)) {
                    cells.say("place " + Scenario.PHONE + " " + cell.field("x") + " " + cell.field("y"));
                    cells.expect("location-update", "number", Scenario.PHONE, "lac", cell.field("lac"));
                    break;
                }
            }
            phone.say("sms " + Scenario.PHONE + " here");
            phone.expect("sms", "text", "here");
        }
    }

    @Test
    void aTowerThatIsSwitchedOffSendsItsPhonesToTheNext() throws Exception {
        try (Scenario town = new Scenario("a tower fails")) {
            town.center();
            RunningProgram cells = town.cells("village.town");
            town.phone(Scenario.PHONE);
            cells.expect("location-update", "number", Scenario.PHONE);
            cells.say("tower west off");
            cells.expect("camped", "number", Scenario.PHONE, "cell", "east");
            cells.say("cells");
            cells.expect("cell", "name", "west", "state", "off");
            cells.say("tower west on");
            cells.expect("camped", "number", Scenario.PHONE, "cell", "west");
        }
    }

    @Test
    void reportsArePrintedOnlyWhenAskedFor() throws Exception {
        try (Scenario town = new Scenario("measurement reports")) {
            town.center();
            RunningProgram cells = town.cells("village.town");
            town.robot("empty.map");
            RunningProgram phone = town.phone(Scenario.PHONE);
            town.call(phone);
            cells.say("reports on");
            ConsoleEvent report = cells.expect("report", "number", Scenario.PHONE);
            assertTrue(report.field("serving").matches("west:[0-9]{1,2}"), report.toString());
            assertTrue(report.field("neighbours").matches("(east:[0-9]{1,2})?"), report.toString());
            int number = Integer.parseInt(report.field("nr"));
            cells.expectNext("report");
            cells.expect("report", "number", Scenario.PHONE, "nr", Integer.toString(number + 2));
        }
    }

    @Test
    void reportsAreWrittenAsCsvBesideTheConsole(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("reports.csv");
        try (Scenario town = new Scenario("reports in a file")) {
            town.center();
            RunningProgram cells = town.cells("village.town", "--reports", file.toString());
            town.robot("empty.map");
            town.call(town.phone(Scenario.PHONE));
            cells.say("reports on");
            cells.expect("report", "number", Scenario.PHONE);
            cells.expectNext("report");
            assertEquals(0, cells.quit());
        }
        List<String> lines = Files.readAllLines(file);
        assertEquals("time,number,cell,rxlev,rxqual,ta,neighbours", lines.get(0));
        String of = Scenario.PHONE + ",west,[0-9]{1,2},[0-7],[0-9]{1,2},(east:[0-9]{1,2})?";
        assertTrue(lines.stream().anyMatch(line -> line.matches("20[-0-9]+T[:.0-9]+Z," + of)), lines.toString());
    }

    @Test
    void aFileForReportsInNoFolderIsAnInputOutputError() throws Exception {
        FinishedProgram cells = FinishedProgram.run(
                "simgsm-cells", "--headless", "--town", "worlds/village.town", "--reports", "/no-folder/x.csv");
        assertEquals(74, cells.status());
        assertTrue(cells.error().contains("/no-folder/x.csv: no such folder"), cells.error());
    }

    @Test
    void thePlaceOfATerminalFollowsARobotOfSimRobot() throws Exception {
        try (Scenario town = new Scenario("a followed robot")) {
            town.center();
            RunningProgram robot = town.robot("empty.map", "--http", "0");
            String port = robot.said("ready").field("http");
            RunningProgram cells = town.cells(
                    "village.town", "--follow", Scenario.PHONE + "=http://127.0.0.1:" + port + "/robots/robot,1000");
            town.phone(Scenario.PHONE);
            cells.expect("camped", "number", Scenario.PHONE, "cell", "west");
            robot.say("place 4 0 0");
            cells.expect("camped", "number", Scenario.PHONE, "cell", "east");
            cells.say("mobiles");
            cells.expect("mobile", "number", Scenario.PHONE, "x", "4000.0", "y", "0.0");
        }
    }
}
