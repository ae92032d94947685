package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import simgsm.modem.at.command.AtCommands;

/** What a set command took, its read command tells: a row for each command that has both forms. */
class AtReadBackTest {
    private static final Pattern ROW = Pattern.compile("- `(AT[^`]*)`.*");
    /** Commands that set an action or a list and read a state: other tests have them. */
    private static final Set<String> OTHERS = Set.of("+CPIN", "+COPS", "+CPMS", "+CPBS", "+CSMS", "^CVOICE");

    /** The values set, and the values read. */
    private static final List<String> ROWS = List.of(
            "+CMEE=2 -> 2",
            "+CSCS=\"GSM\" -> \"GSM\"",
            "+IPR=115200 -> 115200",
            "+IFC=2,1 -> 2,1",
            "+ICF=2,1 -> 2,1",
            "+CVHU=2 -> 2",
            "+CR=1 -> 1",
            "+CMOD=3 -> 3",
            "+CTZU=1 -> 1",
            "+CTZR=1 -> 1",
            "+CLTS=1 -> 1",
            "+CBATCHK=1 -> 1",
            "+CSCLK=2 -> 2",
            "+CMUT=1 -> 1",
            "+CHFA=1 -> 1",
            "+CFGRI=1 -> 1",
            "+CMMS=2 -> 2",
            "+CSSN=1,1 -> 1,1",
            "+CSTA=129 -> 129",
            "+CBST=7,0,1 -> 7,0,1",
            "+CLVL=70 -> 70",
            "+CMIC=1,12 -> 1,12",
            "+WS46=12 -> 12",
            "+CUSD=1 -> 1",
            "+CLIP=1 -> 1,1",
            "+CRC=1 -> 1",
            "+COLP=1 -> 1,1",
            "+GSMBUSY=1 -> 1",
            "+CCWA=1 -> 1",
            "+CLIR=2 -> 2,4",
            "+VTD=7 -> 7",
            "+DDET=1,20,1 -> 1,20,1,0",
            "+CREG=1 -> 1,1",
            "+CGREG=1 -> 1,1",
            "+CGATT=0 -> 0",
            "+CMER=2,0,0,1 -> 2,0,0,1,0",
            "+CCLK=\"26/11/22,06:00:00+04\" -> \"26/11/22,06:00:00+04\"",
            "+CMGF=1 -> 1",
            "+CNMI=2,1,2,1,0 -> 2,1,2,1,0",
            "+CSCA=\"+5550009\",145 -> \"+5550009\",145",
            "+CSMP=17,23,0,0 -> 17,23,0,0",
            "+CSDH=1 -> 1",
            "+CSCB=0,\"50,919\" -> 0,\"50,919\",\"\"",
            "+CFUN=4 -> 4");

    private final VirtualSuite suite = new VirtualSuite();
    private final VirtualModem modem = suite.modem("5550300").connect();

    @Test
    void aCommandReadsBackWhatItHasSet() {
        for (String row : ROWS) {
            String[] setAndRead = row.split(" -> ");
            String name = setAndRead[0].substring(0, setAndRead[0].indexOf('='));
            assertEquals("OK", modem.say("AT" + setAndRead[0]).split("\\|")[0], row);
            String prefix = name.equals("+WS46") ? "" : name + ": ";
            assertEquals(prefix + setAndRead[1] + "|OK", modem.say("AT" + name + "?"), row);
        }
    }

    @Test
    void valuesOutsideTheTestFormsRangesAreRefusedAndWhatIsLeftOutStays() {
        for (String wrong : List.of("+CLVL=101", "+IFC=3", "+IFC=0,0,0", "+CSTA=130", "+CLTS=x", "+CMER=1,1")) {
            assertEquals("ERROR", modem.say("AT" + wrong), wrong);
        }
        modem.say("AT+IFC=2,1");
        assertEquals("+IFC: 1,1|OK", modem.say("AT+IFC=1;+IFC?"));
        assertEquals("+IFC: 1,2|OK", modem.say("AT+IFC=,2;+IFC?"));
        assertEquals("+IFC: 0,0|OK", modem.say("ATE0&FE0;+IFC?").replaceFirst("^AT.*\\|", ""));
    }

    @Test
    void everyCommandThatIsSetAndReadHasARow() {
        Set<String> named = ROWS.stream()
                .map(row -> row.substring(0, row.indexOf('=')))
                .collect(Collectors.toCollection(TreeSet::new));
        named.addAll(OTHERS);
        Set<String> both = AtCommands.toMarkdown()
                .lines()
                .map(ROW::matcher)
                .filter(row -> row.matches())
                .map(row -> row.group(1))
                .filter(forms -> forms.matches("(.* )?AT[^=]*[?].*")
                        && forms.replace("=?", "").contains("="))
                .map(forms -> forms.split("[?= ]")[0].substring(2))
                .collect(Collectors.toCollection(TreeSet::new));
        both.remove("Sn");
        assertEquals(both, named);
    }
}
