package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** A probe of the modem's AT commands, one after the other, in a network with a robot and a second modem. */
class AtCommandsTest {
    private static final String OTHER = "5550301";

    private final VirtualSuite suite = new VirtualSuite(1500);
    private final VirtualModem modem = suite.modem("5550300").connect();

    /** Each line: a command, an arrow, its answer with lines separated by bars. */
    private void probe(String table) {
        List<String> wrong = table.lines()
                .filter(row -> !row.isBlank())
                .map(row -> row.split(" -> ", 2))
                .map(row -> row[0].strip() + " -> " + modem.say(row[0].strip()) + "\n  expected " + row[1].strip())
                .filter(found -> !found.replaceAll("\n  expected ", "\n").matches("(?s)[^\n]* -> ([^\n]*)\n\\1"))
                .toList();
        assertEquals(List.of(), wrong);
    }

    @Test
    void answersAndIdentityAreThoseOfAGsmModem() {
        probe("""
                AT                  -> OK
                at                  -> OK
                ATI                 -> SimGSM|M2|Revision:1.0|OK
                ATQ0 V1 E0 S0=0     -> OK
                ATE0V1+CMEE=1       -> OK
                AT+CMEE?            -> +CMEE: 1|OK
                AT+CMEE=?           -> +CMEE: (0-2)|OK
                ATS0?               -> 000|OK
                ATS3?               -> 013|OK
                ATX4&C1&D2          -> OK
                AT+CGMI             -> SimGSM|OK
                AT+CGMM             -> M2|OK
                AT+CGMR             -> Revision:1.0|OK
                AT+CIMI             -> 001010005550300|OK
                AT+GCAP             -> +GCAP: +CGSM|OK
                AT+WS46=?           -> +WS46: (12)|OK
                AT+CSCS?            -> +CSCS: "IRA"|OK
                AT+CSCS=?           -> +CSCS: ("GSM","IRA","UCS2","HEX")|OK
                AT+CSCS="LATIN"     -> +CME ERROR: 50
                AT+CPIN?            -> +CPIN: READY|OK
                AT+CPIN="1234"      -> +CME ERROR: 3
                AT+CLCK=?           -> +CLCK: ("SC")|OK
                AT+CLCK="SC",2      -> +CLCK: 0|OK
                AT+CNUM             -> +CNUM: "","5550300",129|OK
                AT+MODE=2           -> ERROR
                AT+CPROT=?          -> ERROR
                AT+WIND=?           -> ERROR
                AT+ZPAS=?           -> ERROR
                AT^CVOICE=?         -> ERROR
                AT^CVOICE?          -> ERROR
                AT^DDSETEX=2        -> ERROR
                AT$TSSPCSW=?        -> ERROR
                AT*CNTI=2           -> ERROR
                AT+                 -> ERROR
                AT=                 -> ERROR
                AT+CSQ=             -> ERROR
                garbage             -> ERROR
                AT+CSCS="IRA        -> +CME ERROR: 50
                AT+CMEE=3           -> +CME ERROR: 50
                AT+CMEE=2;+CHLD=7   -> +CME ERROR: Incorrect parameters
                AT+CMEE=0;+CHLD=7   -> ERROR
                """);
        assertTrue(modem.say("AT+CGSN").matches("[0-9]{15}\\|OK"));
        assertTrue(modem.say("AT+CLAC").contains("AT+CMGS"));
    }

    /** The network keeps forwarding and call waiting; M2 itself takes one call. */
    @Test
    void servicesOfTheNetworkAreSetAndAskedFor() {
        modem.say("AT+CMEE=1");
        probe("""
                AT+CCFC=?                  -> +CCFC: (0-5)|OK
                AT+CCFC=0,2                -> +CCFC: 0,7|OK
                AT+CCFC=0,3,"5550299",145  -> OK
                AT+CCFC=0,2                -> +CCFC: 1,1,"+5550299",145|OK
                AT+CCFC=0,0                -> OK
                AT+CCFC=0,2                -> +CCFC: 0,1,"+5550299",145|OK
                AT+CCFC=0,1,,,1            -> OK
                AT+CCFC=4,4                -> OK
                AT+CCFC=0,2,,,7            -> +CCFC: 0,7|OK
                AT+CCFC=5,3,"+5550299"     -> OK
                AT+CCFC=1,2                -> +CCFC: 1,1,"+5550299",145|OK
                AT+CCFC=2,4                -> OK
                AT+CCFC=2,2                -> +CCFC: 0,7|OK
                AT+CCFC=3,2                -> +CCFC: 1,1,"+5550299",145|OK
                AT+CCFC=0,1                -> +CME ERROR: 3
                AT+CCFC=4,2                -> +CME ERROR: 3
                AT+CCFC=0,3                -> +CME ERROR: 50
                AT+CCFC=0,3,"abc"          -> +CME ERROR: 50
                AT+CCFC=6,2                -> +CME ERROR: 50
                AT+CCFC=0,5                -> +CME ERROR: 50
                AT+CCFC=0                  -> +CME ERROR: 50
                AT+CCFC=0,2,,,1            -> +CCFC: 0,1|OK
                AT+CCFC=0,2,,,2            -> +CCFC: 0,2|OK
                AT+CCFC=0,3,"5550299",129,2 -> +CME ERROR: 4
                AT+CCFC=0,2;+CREG?         -> +CCFC: 0,7|+CREG: 0,1|OK
                AT+CCWA=1                  -> OK
                AT+CCWA?                   -> +CCWA: 1|OK
                AT+CCWA=1,2                -> +CCWA: 0,7|OK
                AT+CCWA=1,2,2              -> +CCWA: 0,2|OK
                AT+CCWA=1,1,2              -> +CME ERROR: 4
                AT+CCWA=1,1                -> +CME ERROR: 4
                AT+CLIR?                   -> +CLIR: 0,4|OK
                AT+CLIR=0                  -> OK
                AT+CLIR=1                  -> OK
                """);
    }

    @Test
    void networkIndicatorsAndClockAnswer() {
        probe("""
                AT+CREG?            -> +CREG: 0,1|OK
                AT+CREG=2           -> OK
                AT+CREG?            -> +CREG: 2,1,"0001","0001"|OK
                AT+CREG=?           -> +CREG: (0-2)|OK
                AT+CGREG=2          -> OK
                AT+CGREG?           -> +CGREG: 2,1,"0001","0001"|OK
                AT+CGATT?           -> +CGATT: 1|OK
                AT+CGATT=0;+CGREG?  -> +CGREG: 2,0|OK
                AT+CGATT?           -> +CGATT: 0|OK
                AT+COPS?            -> +COPS: 0,0,"SimGSM"|OK
                AT+COPS=3,2         -> OK
                AT+COPS?            -> +COPS: 0,2,"00101"|OK
                AT+COPS=3,0         -> OK
                AT+COPS=?           -> +COPS: (2,"SimGSM","SimGSM","00101",0),,(0,2,3),(0-2)|OK
                AT+CSQ              -> +CSQ: 25,99|OK
                AT+CSQ=?            -> +CSQ: (0-31,99),(99)|OK
                AT+CIND?            -> +CIND: 5,5,1,0,0,0,0,0|OK
                AT+CFUN?            -> +CFUN: 1|OK
                AT+CBC              -> +CBC: 0,100|OK
                AT+CCLK="26/11/22,06:00:00+04" -> OK
                AT+CCLK?            -> +CCLK: "26/11/22,06:00:00+04"|OK
                AT+CCLK="26/13/22,06:00:00+04" -> ERROR
                AT+CSQ;+CREG?       -> +CSQ: 25,99|+CREG: 2,1,"0001","0001"|OK
                AT+CSQ;+NONE;+CREG? -> +CSQ: 25,99|ERROR
                """);
    }

    @Test
    void registrationIsReportedWhenTheModemIsSwitchedOffAndOn() {
        modem.say("AT+CREG=1");
        assertEquals("OK|+CREG: 0", modem.say("AT+CFUN=0"));
        probe("""
                AT+COPS?  -> +COPS: 2|OK
                AT+CSQ    -> +CSQ: 99,99|OK
                """);
        assertEquals("> ", modem.say("AT+CMGF=1;+CMGS=\"5550301\""));
        modem.send("no network\u001a");
        assertEquals("+CMS ERROR: 331", VirtualModem.lines(modem.result()));
        assertEquals("OK|+CREG: 2|+CREG: 1", modem.say("AT+CFUN=1"));
    }

    @Test
    void filesOfTheSimAreReadByTheirIdentifiers() {
        probe("""
                AT+CRSM=176,12258,0,0,10 -> +CRSM: 144,0,"980001010055050300F7"|OK
                AT+CRSM=176,28589,0,0,4  -> +CRSM: 144,0,"00000002"|OK
                AT+CRSM=176,28486,0,0,17 -> +CRSM: 144,0,"0053696D47534DFFFFFFFFFFFFFFFFFFFF"|OK
                AT+CRSM=176,28599,0,0,15 -> +CRSM: 144,0,"11F2FFFFFFFFFFFFFFFFFFFFFFFFFF"|OK
                AT+CRSM=178,28480,1,4,14 -> +CRSM: 144,0,"0581550503F0FFFFFFFFFFFFFFFF"|OK
                AT+CRSM=176,28423,0,0,9  -> +CRSM: 144,0,"080910100050553000"|OK
                AT+CRSM=176,1,0,0,4      -> +CRSM: 148,4|OK
                AT+CRSM=176,28589,0,0,99 -> +CRSM: 103,0|OK
                AT+CRSM=214,28589,0,0,4  -> +CRSM: 109,0|OK
                AT+CSIM=10,"0020000100"  -> ERROR
                """);
    }

    @Test
    void thePhoneBookIsWrittenReadSearchedAndDialled() {
        probe("""
                AT+CMEE=1                          -> OK
                AT+CPBS=?                          -> +CPBS: ("SM","ON","LD","RC","MC")|OK
                AT+CPBS?                           -> +CPBS: "SM",0,100|OK
                AT+CPBR=?                          -> +CPBR: (1-100),20,20|OK
                AT+CPBW=1,"5550200",129,"Robot"    -> OK
                AT+CPBW=,"+5550301",145,"Other"    -> OK
                AT+CPBR=1,100                      -> +CPBR: 1,"5550200",129,"Robot"|+CPBR: 2,"+5550301",145,"Other"|OK
                AT+CPBF="Ot"                       -> +CPBF: 2,"+5550301",145,"Other"|OK
                AT+CPBW=2                          -> OK
                AT+CPBR=2                          -> OK
                AT+CPBR=101                        -> +CME ERROR: 21
                AT+CPBW=3,"12x"                    -> +CME ERROR: 27
                AT+CPBW=3,"1",129,"a name of more than twenty letters" -> +CME ERROR: 24
                ATD>"Robot";                       -> OK
                ATH                                -> OK
                ATD>1;                             -> OK
                ATH                                -> OK
                ATD>7;                             -> +CME ERROR: 21
                AT+CPBS="LD"                       -> OK
                AT+CPBR=1                          -> +CPBR: 1,"5550200",129,""|OK
                AT+CPBS="ON"                       -> OK
                AT+CPBR=1                          -> +CPBR: 1,"5550300",129,""|OK
                """);
    }

    @Test
    void aCallToTheRobotIsDialledKeyedHeardAndEnded() {
        modem.say("AT+DDET=1");
        assertEquals("OK", modem.say("AT+CLCC"));
        assertEquals("OK", modem.say("ATDT5550200;"));
        assertEquals("+CLCC: 1,0,3,0,0,\"5550200\",129|OK", modem.say("AT+CLCC"));
        suite.seconds(2);
        assertEquals("+DTMF: 1", VirtualModem.lines(modem.heard()));
        assertEquals("+CLCC: 1,0,0,0,0,\"5550200\",129|OK", modem.say("AT+CLCC"));
        assertEquals("+CPAS: 4|OK", modem.say("AT+CPAS"));
        String keyed = modem.say("AT+VTS=*,*,#,*,*,2,0,*,*");
        suite.seconds(5);
        assertEquals("OK|+DTMF: 6|+DTMF: 3", keyed + "|" + VirtualModem.lines(modem.heard()));
        assertEquals(1, suite.robotLines("outcome robot=robot tone=3").size());
        assertEquals("OK", modem.say("AT+CHUP"));
        suite.seconds(1);
        assertEquals("OK", modem.say("AT+CLCC"));
        assertEquals("ERROR", modem.say("AT+VTS=1"));
        assertEquals("+CEER: 16,\"normal call clearing\"|OK", modem.say("AT+CEER"));
    }

    @Test
    void keysAreSentInAllFormsOfVts() {
        modem.say("ATD5550200;");
        suite.seconds(2);
        for (String form : List.of("\"**\"", "#", "{*,2}", "\"*\"", "2,0", "{*,3},*")) {
            assertEquals("OK", modem.say("AT+VTS=" + form), form);
        }
        suite.seconds(5);
        assertEquals(1, suite.robotLines("outcome robot=robot tone=3").size());
        probe("""
                AT+VTD=2      -> OK
                AT+VTD?       -> +VTD: 2|OK
                AT+VTS=?      -> +VTS: (0-9,A-D,*,#)|OK
                AT+VTS=       -> ERROR
                AT+VTS=x      -> ERROR
                AT+VTS=1,     -> ERROR
                AT+VTS=12     -> ERROR
                AT+VTS={1     -> ERROR
                AT+VTS={1,999} -> ERROR
                AT+VTS=""     -> ERROR
                AT+VTS="1,"   -> ERROR
                AT+VTS="1,,2" -> ERROR
                AT+VTS={12,3} -> ERROR
                """);
    }

    @Test
    void eachKeyOfAListHasItsOwnLength() {
        VirtualModem other = suite.modem(OTHER).connect();
        modem.say("ATD" + OTHER + ";");
        suite.seconds(0.2);
        other.say("AT+DDET=1,0,1;A");
        modem.say("AT+VTD=3");
        assertEquals("OK", modem.say("AT+VTS={6,2},5,{7,12},\"1,2\",{3,0}"));
        suite.seconds(1);
        List<Long> tenths = VirtualModem.lines(other.heard())
                .lines()
                .flatMap(line -> List.of(line.split("\\|")).stream())
                .map(code -> Math.round(Integer.parseInt(code.split(",")[1]) / 100.0))
                .toList();
        assertEquals(List.of(2L, 3L, 12L, 3L, 3L, 1L), tenths);
    }

    @Test
    void aKeysLengthIsReportedOnceItsToneHasEnded() {
        modem.say("AT+DDET=1,0,1");
        modem.say("ATD5550200;");
        suite.seconds(2);
        String heard = VirtualModem.lines(modem.heard());
        assertTrue(heard.matches("\\+DTMF: 1,1[45][0-9]"), heard);
        probe("""
                AT+DDET?          -> +DDET: 1,0,1,0|OK
                AT+DDET=?         -> +DDET: (0,1),(0-10000),(0,1),(0)|OK
                AT+DDET=1,10001   -> ERROR
                AT+DDET=1,0,0,1   -> ERROR
                """);
    }

    @Test
    void aSecondEqualKeyWithinTheIntervalIsNotReported() {
        VirtualPhone caller = suite.phone("5550100");
        modem.say("AT+DDET=1,1000");
        caller.dial("5550300");
        suite.seconds(0.2);
        modem.say("ATA");
        caller.press("**12");
        assertEquals("+DTMF: *|+DTMF: 1|+DTMF: 2", VirtualModem.lines(modem.heard()));
    }

    @Test
    void anIncomingCallRingsWithItsNumberAndIsAnswered() {
        VirtualPhone caller = suite.phone("5550100");
        probe("""
                AT+CLIP=1 -> OK
                AT+CLIP?  -> +CLIP: 1,1|OK
                """);
        caller.dial("5550300");
        suite.seconds(3.5);
        assertEquals(
                "RING|+CLIP: \"5550100\",129,,,,0|RING|+CLIP: \"5550100\",129,,,,0", VirtualModem.lines(modem.heard()));
        assertEquals("+CPAS: 3|OK", modem.say("AT+CPAS"));
        assertEquals("+CLCC: 1,1,4,0,0,\"5550100\",129|OK", modem.say("AT+CLCC"));
        assertEquals("OK", modem.say("ATA"));
        assertEquals("+CLCC: 1,1,0,0,0,\"5550100\",129|OK", modem.say("AT+CLCC"));
        caller.hangUp();
        assertEquals("NO CARRIER", VirtualModem.lines(modem.heard()));
        assertEquals("NO CARRIER", modem.say("ATA"));
    }

    @Test
    void ofTwoClientsThatAnswerACallAtOnceTheFirstHasIt() {
        VirtualPhone caller = suite.phone("5550100");
        caller.dial("5550300");
        suite.seconds(0.2);
        assertEquals(List.of("OK", "NO CARRIER"), modem.sayTogether("ATA"));
    }

    @Test
    void ringsAreNamedByTheirKindAndAnsweredAfterTheirNumber() {
        VirtualPhone caller = suite.phone("5550100");
        modem.say("AT+CRC=1;S0=2");
        caller.dial("5550300");
        suite.seconds(2);
        assertEquals("+CRING: VOICE", VirtualModem.lines(modem.heard()));
        suite.seconds(2);
        assertEquals("+CLCC: 1,1,0,0,0,\"5550100\",129|OK", modem.say("AT+CLCC"));
    }

    @Test
    void callsThatFailAreReportedByTheirReason() {
        VirtualModem other = suite.modem(OTHER).connect();
        assertEquals("OK", modem.say("ATD" + OTHER + ";"));
        suite.seconds(0.5);
        assertEquals("+CLCC: 1,0,3,0,0,\"5550301\",129|OK", modem.say("AT+CLCC"));
        other.say("ATH");
        suite.seconds(0.5);
        assertEquals("NO CARRIER", VirtualModem.lines(modem.heard()));
        VirtualPhone first = suite.inCall();
        assertEquals("OK|BUSY", modem.say("ATD5550200;"));
        suite.seconds(0.5);
        assertEquals("OK|NO CARRIER", modem.say("ATX0D5550200;"));
        first.hangUp();
        probe("""
                AT+CMEE=1         -> OK
                ATD5550200        -> NO CARRIER
                ATDT              -> NO CARRIER
                ATD;              -> +CME ERROR: 27
                ATD12ab;          -> +CME ERROR: 27
                ATD>"nobody";     -> +CME ERROR: 22
                """);
    }

    @Test
    void aWaitingCallIsReportedRejectedOrTaken() {
        VirtualPhone first = suite.phone("5550100");
        VirtualPhone second = suite.phone("5550101");
        modem.say("AT+CCWA=1");
        first.dial("5550300");
        suite.seconds(0.2);
        modem.say("ATA");
        second.dial("5550300");
        suite.seconds(0.2);
        assertEquals(List.of(), second.releaseCauses);
        assertEquals("+CCWA: \"5550101\",129,1", VirtualModem.lines(modem.heard()));
        assertEquals("+CLCC: 1,1,0,0,0,\"5550100\",129|+CLCC: 2,1,5,0,0,\"5550101\",129|OK", modem.say("AT+CLCC"));
        assertEquals("OK", modem.say("AT+CHLD=0"));
        suite.seconds(0.2);
        assertEquals(List.of(17), second.releaseCauses);
        second.dial("5550300");
        suite.seconds(0.2);
        assertEquals("OK", modem.say("AT+CHLD=1"));
        suite.seconds(0.5);
        assertEquals(List.of(16), first.releaseCauses);
        assertEquals("+CLCC: 1,1,0,0,0,\"5550101\",129|OK", modem.say("AT+CLCC"));
        assertEquals("ERROR", modem.say("AT+CHLD=2"));
        assertEquals("+CHLD: (0,1)|OK", modem.say("AT+CHLD=?"));
    }

    @Test
    void aTextMessageIsSentReportedReceivedReadAndDeleted() {
        VirtualModem other = suite.modem(OTHER).connect();
        other.say("AT+CMGF=1;+CNMI=2,1,0,0,0");
        probe("""
                AT+CMGF=?               -> +CMGF: (0,1)|OK
                AT+CMGF=1               -> OK
                AT+CSMP?                -> +CSMP: 17,167,0,0|OK
                AT+CSMP=49,167,0,0      -> OK
                AT+CNMI=2,1,0,1,0       -> OK
                AT+CNMI?                -> +CNMI: 2,1,0,1,0|OK
                AT+CNMI=?               -> +CNMI: (0-2),(0-3),(0,2),(0-2),(0,1)|OK
                """);
        String sent = modem.say("AT+CMGS=\"" + OTHER + "\"", "Hello {world}");
        assertTrue(
                sent.matches(
                        "\\+CMGS: ([0-9]+)\\|OK\\|\\+CDS: [0-9]+,\\1,\"\\+?5550301\",(129|145),\"[^\"]+\",\"[^\"]+\",0"),
                sent);
        assertEquals("+CMTI: \"SM\",1", VirtualModem.lines(other.heard()));
        String read = other.say("AT+CMGR=1");
        assertTrue(
                read.matches(
                        "\\+CMGR: \"REC UNREAD\",\"5550300\",,\"26/11/21,12:00:[0-9]{2}\\+00\"\\|Hello \\{world}\\|OK"),
                read);
        assertTrue(other.say("AT+CSDH=1;+CMGR=1").contains("\"REC READ\""));
        assertTrue(other.say("AT+CMGL=\"ALL\"").startsWith("+CMGL: 1,\"REC READ\",\"5550300\",,"));
        assertEquals("OK", other.say("AT+CMGL"));
        assertEquals("OK", other.say("AT+CMGD=1"));
        assertEquals("+CMS ERROR: 321", other.say("AT+CMGR=1"));
        assertEquals("OK", other.say("AT+CMGL=\"ALL\""));
    }

    @Test
    void aMessageInPduModeIsSentAsItIsAndReceivedOctetForOctet() {
        VirtualModem other = suite.modem(OTHER).connect();
        probe("""
                AT+CMGF?    -> +CMGF: 0|OK
                AT+CSCA?    -> +CSCA: "5550000",129|OK
                AT+CMGS=3   -> +CMS ERROR: 304
                AT+CMGS=999 -> +CMS ERROR: 304
                AT+CMGR=0   -> +CMS ERROR: 321
                AT+CMGR=51  -> +CMS ERROR: 321
                """);
        String sent = modem.say("AT+CMGS=17", "0011000791550503F10000A705E8329BFD06");
        assertTrue(sent.matches("\\+CMGS: [0-9]+\\|OK"), sent);
        suite.seconds(0.5);
        String list = other.say("AT+CMGL=4");
        assertTrue(
                list.matches("\\+CMGL: 1,0,,22\\|05815505000004078155050300F0?.*E8329BFD06\\|OK")
                        || list.contains("E8329BFD06|OK"),
                list);
        assertEquals("+CMS ERROR: 304", modem.say("AT+CMGS=18", "00110007915555"));
        assertEquals("+CMS ERROR: 304", modem.say("AT+CMGS=18", "no digits at all"));
    }

    @Test
    void aMessageIsGivenUpWithEscapeAndByTime() {
        modem.say("AT+CMGF=1");
        assertEquals("> ", modem.say("AT+CMGS=\"5550301\""));
        modem.send("never mind\u001b");
        assertEquals("OK", VirtualModem.lines(modem.result()));
        assertEquals("> ", modem.say("AT+CMGS=\"5550301\""));
        suite.seconds(61);
        assertEquals("ERROR", VirtualModem.lines(modem.heard()));
        assertEquals("OK", modem.say("AT"));
    }

    @Test
    void aLineFeedAfterTheCommandIsNotPartOfTheMessage() {
        VirtualModem other = suite.modem(OTHER).connect();
        modem.send("AT+CMGF=1\r\nAT+CMGS=\"" + OTHER + "\"\r\ntext\u001a");
        suite.seconds(1);
        assertTrue(other.say("AT+CMGF=1;+CMGL=\"ALL\"").endsWith("|text|OK"));
    }

    @Test
    void textsPassInAllCharacterSets() {
        VirtualModem other = suite.modem(OTHER).connect();
        other.say("AT+CMGF=1;+CSCS=\"UCS2\"");
        modem.say("AT+CMGF=1;+CSCS=\"GSM\"");
        modem.say("AT+CMGS=\"" + OTHER + "\"", "a\u0000\u0011");
        modem.say("AT+CSCS=\"UCS2\"");
        modem.say("AT+CMGS=\"0035003500350030003300300031\"", "20AC0416");
        suite.seconds(0.5);
        assertTrue(other.say("AT+CMGR=1").endsWith("|00610040005F|OK"));
        assertTrue(other.say("AT+CMGR=2").endsWith("|20AC0416|OK"));
        assertEquals("+COPS: 0,0,\"00530069006D00470053004D\"|OK", other.say("AT+COPS?"));
        other.say("AT+CSCS=\"IRA\"");
        assertTrue(other.say("AT+CMGR=1").endsWith("|a@_|OK"));
        assertEquals("+CMS ERROR: 305", modem.say("AT+CMGS=\"" + OTHER + "\"", "xyz"));
    }

    @Test
    void aStoredMessageIsSentFromItsPlace() {
        VirtualModem other = suite.modem(OTHER).connect();
        probe("""
                AT+CMGF=1 -> OK
                """);
        assertEquals("+CMGW: 1|OK", modem.say("AT+CMGW=\"" + OTHER + "\"", "kept"));
        assertEquals("+CMGL: 1,\"STO UNSENT\",\"5550301\",,|kept|OK", modem.say("AT+CMGL=\"STO UNSENT\""));
        assertTrue(modem.say("AT+CMSS=1").matches("\\+CMSS: [0-9]+\\|OK"));
        assertEquals("+CMGL: 1,\"STO SENT\",\"5550301\",,|kept|OK", modem.say("AT+CMGL=\"STO SENT\""));
        assertTrue(modem.say("AT+CMSS=1,\"5550300\"").matches("\\+CMSS: [0-9]+\\|OK"));
        assertEquals("+CMS ERROR: 321", modem.say("AT+CMSS=9"));
        suite.seconds(0.5);
        assertTrue(other.say("AT+CMGF=1;+CMGL=\"ALL\"").endsWith("|kept|OK"));
        assertEquals("+CPMS: 2,50,2,50,2,50|OK", modem.say("AT+CPMS=\"SM\",\"SM\",\"SM\""));
        assertEquals("OK", modem.say("AT+CMGD=1,4"));
        assertEquals("+CPMS: \"SM\",0,50,\"SM\",0,50,\"SM\",0,50|OK", modem.say("AT+CPMS?"));
        assertEquals("+CMS ERROR: 303", modem.say("AT+CPMS=\"ME\""));
        assertEquals("+CPMS: (\"SM\"),(\"SM\"),(\"SM\")|OK", modem.say("AT+CPMS=?"));
    }

    @Test
    void aMessagePassedDirectlyIsNotStoredAndIsAcknowledged() {
        VirtualModem other = suite.modem(OTHER).connect();
        other.say("AT+CMGF=1;+CNMI=2,2;+CSMS=1");
        modem.say("AT+CMGF=1");
        modem.say("AT+CMGS=\"" + OTHER + "\"", "now");
        suite.seconds(0.5);
        assertTrue(VirtualModem.lines(other.heard()).matches("\\+CMT: \"5550300\",,\"[^\"]+\"\\|now"));
        assertEquals("OK", other.say("AT+CMGL=\"ALL\""));
        assertEquals("OK", other.say("AT+CNMA"));
        assertEquals("+CMS ERROR: 340", other.say("AT+CNMA"));
    }

    @Test
    void aFullMemoryRefusesMessagesUntilThereIsRoomAgain() {
        VirtualModem other = suite.modem(OTHER).connect();
        modem.say("AT+CMGF=1");
        IntStream.rangeClosed(1, 52).forEach(i -> modem.say("AT+CMGS=\"" + OTHER + "\"", "message " + i));
        suite.seconds(1);
        assertEquals("+CPMS: \"SM\",50,50,\"SM\",50,50,\"SM\",50,50|OK", other.say("AT+CPMS?"));
        assertTrue(other.say("AT+CIND?").startsWith("+CIND: 5,5,1,1,0,0,1,0"));
        assertEquals("OK", other.say("AT+CMGD=7"));
        suite.seconds(1);
        assertTrue(other.say("AT+CMGF=1;+CMGR=7").endsWith("|message 51|OK"));
        assertEquals("OK", other.say("AT+CMGD=1,4"));
        suite.seconds(1);
        assertTrue(other.say("AT+CMGR=1").endsWith("|message 52|OK"));
    }

    @Test
    void beforeAnyClientHasConnectedTheOldestMessageMakesRoom() {
        VirtualModem other = suite.modem(OTHER);
        modem.say("AT+CMGF=1");
        IntStream.rangeClosed(1, 51).forEach(i -> modem.say("AT+CMGS=\"" + OTHER + "\"", "message " + i));
        suite.seconds(1);
        other.connect().say("AT+CMGF=1");
        assertTrue(other.say("AT+CMGR=1").endsWith("|message 51|OK"));
        assertTrue(other.say("AT+CMGR=2").endsWith("|message 2|OK"));
    }

    @Test
    void codesWaitForTheEndOfTheCommand() {
        VirtualPhone caller = suite.phone("5550100");
        modem.send("AT+CS");
        caller.dial("5550300");
        suite.seconds(1);
        assertEquals("", modem.heard());
        modem.send("Q\r");
        assertEquals("+CSQ: 25,99|OK|RING", VirtualModem.lines(modem.heard()));
        modem.send("AT+CS");
        suite.seconds(6);
        assertTrue(modem.heard().startsWith("\r\nRING\r\n"), "an incomplete line holds codes back for 2 s at most");
        modem.send("Q\r");
        assertTrue(VirtualModem.lines(modem.heard()).startsWith("+CSQ: 25,99|OK"));
    }

    @Test
    void numericAndQuietResultsEchoAndRepetitionFollowV250() {
        modem.send("ATE1\r");
        modem.heard();
        modem.send("AT+CSQ\r");
        assertEquals("AT+CSQ\r\r\n+CSQ: 25,99\r\n\r\nOK\r\n", modem.heard());
        modem.send("A/");
        assertEquals("A/\r\n+CSQ: 25,99\r\n\r\nOK\r\n", modem.heard());
        modem.send("ATE0V0\r");
        assertEquals("ATE0V0\r0\r", modem.heard());
        modem.send("AT+CSQ\r");
        assertEquals("+CSQ: 25,99\r\n0\r", modem.heard());
        modem.send("AT+NONE\r");
        assertEquals("4\r", modem.heard());
        modem.send("ATQ1\r");
        assertEquals("", modem.heard());
        modem.send("ATQ0V1\r");
        assertEquals("\r\nOK\r\n", modem.heard());
    }

    @Test
    void linesWithoutACommandGetNoAnswer() {
        for (String line : List.of("\r", "\n", "\r\n", "\u001b\r", " \r", "AT+CSQ\u001b\r", "ATX\b\b\b\r")) {
            modem.send(line);
            assertEquals("", modem.heard());
        }
    }

    @Test
    void ussdIsAskedAndAnswered() {
        probe("""
                AT+CUSD=?         -> +CUSD: (0-2)|OK
                AT+CUSD=1         -> OK
                AT+CUSD?          -> +CUSD: 1|OK
                """);
        assertEquals("OK|+CUSD: 0,\"5550300\",15", modem.say("AT+CUSD=1,\"*100#\",15"));
        assertEquals("OK|+CUSD: 0,\"5550300\",15", modem.say("ATD*100#;"));
        modem.say("AT+CSCS=\"UCS2\"");
        assertEquals(
                "OK|+CUSD: 0,\"0035003500350030003300300030\",15", modem.say("AT+CUSD=1,\"002A0031003000300023\",15"));
        assertEquals("OK", modem.say("AT+CUSD=2"));
    }

    @Test
    void everyCodeIsAnsweredWithAText() {
        String imei = modem.say("AT+CGSN").split("\\|")[0];
        String identity = "OK|+CUSD: 0,\"" + imei + "\",15";
        assertEquals(identity, modem.say("ATD*#06#;"));
        assertEquals("OK", modem.say("AT+CUSD=0,\"*#06#\""));
        assertEquals(identity, modem.say("AT+CUSD=1,\"*#06#\""));
        modem.say("AT+CUSD=0");
        for (String row : List.of(
                "*#21# -> forwarding unconditional: inactive",
                "*21*5550132# -> forwarding unconditional: active, 5550132",
                "*#21# -> forwarding unconditional: active, 5550132",
                "**61*+5550299# -> forwarding on no reply: active, +5550299",
                "#61# -> forwarding on no reply: registered, +5550299",
                "##002# -> all forwarding: inactive",
                "*43# -> call waiting: active",
                "*#31# -> calling line restriction: inactive")) {
            String[] codeAndText = row.split(" -> ");
            assertEquals("OK|+CUSD: 0,\"" + codeAndText[1] + "\",15", modem.say("ATD" + codeAndText[0] + ";"), row);
        }
        assertEquals("OK|+CUSD: 4", modem.say("ATD*#33#;"));
        assertEquals("OK", modem.say("AT+CUSD=0,\"*100#\""));
        assertEquals("", modem.heard());
    }

    /** TS 27.007, 7.17: +CSSI about a client's own call, +CSSU about what others have done. */
    @Test
    void forwardingAndHoldAreReportedToAClientThatAsksForIt() {
        VirtualModem other = suite.modem(OTHER).connect();
        VirtualPhone phone = suite.phone("5550100");
        other.say("AT+CSSN=0,1");
        modem.say("AT+CSSN=1,0");
        modem.say("AT+CCFC=0,3,\"" + OTHER + "\",129");
        assertEquals("OK|+CSSI: 0", modem.say("ATD5550100;"));
        modem.say("ATH");
        suite.seconds(1);

        phone.dial("5550300");
        suite.seconds(0.2);
        assertEquals("RING|+CSSU: 0", VirtualModem.lines(other.heard()));
        other.say("ATA");
        suite.seconds(0.2);
        phone.station().hold();
        suite.seconds(0.2);
        assertEquals("+CSSU: 2", VirtualModem.lines(other.heard()));
        phone.station().hold();
        suite.seconds(0.2);
        assertEquals("+CSSU: 3", VirtualModem.lines(other.heard()));
        assertEquals("", modem.heard());
    }

    @Test
    void theCodesThatShowAndHideTheOwnNumberPrecedeACall() {
        VirtualModem other = suite.modem(OTHER).connect();
        assertEquals("OK", modem.say("ATD*31#" + OTHER + ";"));
        suite.seconds(0.2);
        assertEquals("RING", VirtualModem.lines(other.heard()));
        modem.say("ATH");
        suite.seconds(1);
        other.heard();
        other.say("AT+CLIP=1");
        assertEquals("OK", modem.say("ATD#31#" + OTHER + ";"));
        suite.seconds(0.2);
        assertEquals("RING|+CLIP: \"\",129,,,,1", VirtualModem.lines(other.heard()));
    }

    @Test
    void messagesAreDeletedByKind() {
        modem.say("AT+CMGF=1");
        modem.say("AT+CMGW=\"5550301\"", "kept");
        modem.say("AT+CMGW=\"5550301\",145,\"STO SENT\"", "sent");
        probe("""
                AT+CMGDA="DEL INBOX" -> OK
                AT+CPMS="SM"         -> +CPMS: 2,50,2,50,2,50|OK
                AT+CMGDA="DEL SENT"  -> OK
                AT+CPMS="SM"         -> +CPMS: 1,50,1,50,1,50|OK
                AT+CMGDA=6           -> OK
                AT+CPMS="SM"         -> +CPMS: 0,50,0,50,0,50|OK
                AT+CMGDA="ALL"       -> +CMS ERROR: 321
                """);
    }

    @Test
    void settingsBelongToTheConnectionAndMessagesToTheModem() {
        modem.say("AT+CMGF=1;+CREG=2");
        modem.say("AT+CMGW=\"5550301\"", "kept");
        modem.disconnect();
        modem.connect();
        probe("""
                AT+CMGF?  -> +CMGF: 0|OK
                AT+CREG?  -> +CREG: 0,1|OK
                AT+CPMS?  -> +CPMS: "SM",1,50,"SM",1,50,"SM",1,50|OK
                AT+CMGF=1 -> OK
                ATE0Z     -> OK
                """);
        modem.send("ATE0\r");
        modem.heard();
        assertEquals("+CMGF: 0|OK", modem.say("AT+CMGF?"));
    }
}
