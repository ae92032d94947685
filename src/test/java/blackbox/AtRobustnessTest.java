package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** Whatever a client sends, each command ends with a final result. */
class AtRobustnessTest {
    private static final int LINES = 100_000;
    /** Lines after which the modem is connected to anew, as its settings and calls have become accidental. */
    private static final int LINES_PER_CLIENT = 1_000;

    /** What the clients of the facts sheet send, and lines with more parameters. */
    static final List<String> LINES_OF_CLIENTS = List.of(
            // ModemManager
            "ATE0 ATV1 AT+CMEE=1 ATX4 AT&C1 AT+GCAP AT+WS46=? AT+CSCS=? AT+CSCS=\"UCS2\" AT+CSCS? AT+CGMI AT+CGMM AT+CGMR",
            "AT+CGSN ATI AT*CNTI=2 AT+CGDCONT=? AT+CFUN? AT+CPIN? AT+CSIM=10,\"0020000100\" AT+CRSM=176,12258,0,0,10",
            "AT+CIMI AT+CRSM=176,28589,0,0,4 AT+CRSM=176,28486,0,0,17 AT+CRSM=176,28599,0,0,15 AT+CPLS=0 AT+CPOL=,2",
            "AT+CPOL? AT+CNUM AT+CLCK=? AT+CEMODE? AT+CUSD=? AT+CNMI=? AT+CPMS=? AT+CPMS? AT+CTZU=1 AT+CCLK? AT+CESQ=?",
            "ATH AT+CLCC=? AT+IFC=? AT+CIND=? AT+CGEREP=? AT+CGEREP=2 AT+CREG=2 AT+CGREG=2 AT+CUSD=1 AT+CREG? AT+CMGF=?",
            "AT+CGREG? AT+CMGF=0 AT+CPMS=\"SM\",\"SM\",\"SM\" AT+CPMS=\"SM\" AT+CMGL=4 AT+CNMI=2,1,2,1,0 AT+CLIP=1 AT+CRC=1",
            "AT+CCWA=1 AT+COPS=3,2 AT+COPS? AT+COPS=3,0 AT+COPS? AT+CSQ AT+CMGS=21 ATD5550200; AT+VTS=5 AT+CHUP",
            // smstools
            "AT ATE0 AT+CMEE=1;+CREG=2 AT+CPIN? AT+CSQ AT+CREG? AT+CMGF=0 AT+CGSN AT+CIMI AT+CPMS? AT+CMGR=1 AT+CMGD=1",
            "AT+CMGS=22",
            // gammu
            "ATE1 AT+MODE=2 AT+CMEE=1 AT+CSCS? AT+CSCS=? AT+CPROT=? AT+SYNCML=? AT$TSSPCSW=? AT+CHUP=? AT+CFUN=1 AT+CSCA?",
            "AT+VTS=*,*,#,*,*,2,0,*,* AT+CUSD=1 AT+CSCS=\"UCS2\" AT+CUSD=1,\"002A0031003000300023\",15 ATDT5550200; ATA",
            "AT+CPMS=\"ME\" AT+CMMS=2 AT+CBC AT+CPBS=\"SM\" AT+CPBR=1,10",
            // python-gsmmodem-new
            "ATZ ATE0 AT+CLAC AT+WIND? AT+ZPAS? AT+CSMP=49,167,0,0 AT+CNMI=2,1,0,2 AT+CVHU=0 AT+DDET=1 AT+CLCC",
            // chan_dongle
            "AT^U2DIAG=0 AT+COPS=0,0 AT^CVOICE? AT+CSSN=1,1 AT+CNMI=2,1,0,0,0 AT+CLIR=0 AT^DDSETEX=2 AT^DTMF=1,5",
            // others
            "AT+CPBW=1,\"5550200\",129,\"Robot\" AT+CMGF=1 AT+CMGS=\"5550200\" AT+CMGW=\"5550200\" AT+CSCB=0,\"50\" AT+CMER=3,0,0,1",
            "AT+DDET=1,1000,1,0 AT+VTD=3 AT+CCLK=\"26/11/22,06:00:00+04\" AT+CHLD=1 AT+CNMA=0 AT+CMSS=1 AT+CMGC=20 ATD>1;");

    /** ATQ1 asks for no results. */
    private static final Pattern WITHOUT_RESULTS = Pattern.compile("[Qq] *0*1");

    private final SplittableRandom random = new SplittableRandom(11);
    private final VirtualSuite suite = new VirtualSuite();
    private final VirtualModem modem = suite.modem("5550300").connect();

    static List<String> commands() {
        List<String> commands = new ArrayList<>();
        LINES_OF_CLIENTS.forEach(line -> commands.addAll(List.of(line.split(" "))));
        return commands;
    }

    @Test
    void everyDialogueOfTheFactsSheetEndsEachCommandWithAFinalResult() {
        modem.send("ATE1\r");
        modem.heard();
        for (String command : commands()) {
            String answer = modem.say(command);
            if (answer.strip().endsWith(">")) {
                modem.send("\u001b");
                answer = VirtualModem.lines(modem.result());
            }
            assertTrue(
                    answer.matches("(?s).*(OK|ERROR|NO CARRIER|\\+CM[ES] ERROR: .*)(\\|.*)?"), command + ": " + answer);
        }
        assertTrue(commands().size() > 130, "commands: " + commands().size());
    }

    @Test
    void aHundredThousandMutatedLinesAllGetAFinalResult() {
        List<String> commands = commands();
        for (int i = 0; i < LINES; i++) {
            if (i % LINES_PER_CLIENT == 0) {
                modem.connect();
                modem.say("AT+CMGD=1,4");
            }
            String line = mutated(commands.get(random.nextInt(commands.size())), commands);
            if (line.isBlank() || WITHOUT_RESULTS.matcher(line).find()) {
                continue;
            }
            modem.say("ATE0V1Q0+CMEE=1");
            String answer = modem.say(line);
            if (answer.strip().endsWith(">")) {
                modem.send(mutated("0011000791550503F10000A705E8329BFD06", commands) + "\u001a\u001b");
                modem.result();
            }
        }
        modem.connect();
        assertEquals("OK", modem.say("AT").replaceAll("\\|.*", ""));
    }

    /** One to three changes of a line; no control characters, which end or erase it. */
    private String mutated(String line, List<String> commands) {
        StringBuilder changed = new StringBuilder(line);
        for (int changes = 1 + random.nextInt(3); changes > 0; changes--) {
            int at = random.nextInt(changed.length() + 1);
            switch (random.nextInt(6)) {
                case 0 -> changed.insert(at, (char) (' ' + random.nextInt(224)));
                case 1 -> changed.insert(at, ",\";={}?+*#0123456789ATDV".charAt(random.nextInt(24)));
                case 2 -> changed.delete(at, Math.min(changed.length(), at + 1 + random.nextInt(3)));
                case 3 -> changed.insert(at, random.nextInt(100_000));
                case 4 ->
                    changed.append(';')
                            .append(commands.get(random.nextInt(commands.size()))
                                    .substring(2));
                default -> changed.insert(at, line);
            }
        }
        return changed.toString().replace("\u007f", "~");
    }
}
