package simgsm.words;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class SpokenReplyTest {
    private static String said(SpokenLanguage language, String text) {
        return new SpokenReply(Prompts.of(language)).read(text).text();
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "0, Zero, Cero",
        "1, One, Uno",
        "16, Sixteen, Dieciséis",
        "20, Twenty, Veinte",
        "21, Twenty one, Veintiuno",
        "22, Twenty two, Veintidós",
        "31, Thirty one, Treinta y uno",
        "99, Ninety nine, Noventa y nueve",
        "100, One hundred, Cien",
        "101, One hundred one, Ciento uno",
        "110, One hundred ten, Ciento diez",
        "200, Two hundred, Doscientos",
        "515, Five hundred fifteen, Quinientos quince",
        "700, Seven hundred, Setecientos",
        "931, Nine hundred thirty one, Novecientos treinta y uno",
        "1000, One thousand, Mil",
        "1100, One thousand one hundred, Mil cien",
        "2021, Two thousand twenty one, Dos mil veintiuno",
        "9999, Nine thousand nine hundred ninety nine, Nueve mil novecientos noventa y nueve",
        "10000, One zero zero zero zero, Uno cero cero cero cero",
        "89.70, Eighty nine point seven, Ochenta y nueve coma siete",
        "90.0, Ninety, Noventa",
        "0.05, Zero point zero five, Cero coma cero cinco",
        "-3.5, Minus three point five, Menos tres coma cinco",
        "-0.0, Zero, Cero",
        "1 cm, One centimeter, Un centímetro",
        "21 cm, Twenty one centimeters, Veintiún centímetros",
        "31 cm, Thirty one centimeters, Treinta y un centímetros",
        "101 cm, One hundred one centimeters, Ciento un centímetros",
        "0.000 1.000 m, X zero meters y one meter, Equis cero metros i griega un metro",
        "2.200 -0.500 m, X two meters twenty y minus fifty centimeters, Equis dos metros veinte i griega menos cincuenta centímetros",
        "21.050 0.014 m, X twenty one meters five centimeters y one centimeter, "
                + "Equis veintiún metros cinco centímetros i griega un centímetro",
        "-0.004 0.999 m, X zero meters y one meter, Equis cero metros i griega un metro",
    })
    void numbersAreSaidAsInTheLanguage(String text, String english, String spanish) {
        assertEquals(english, said(SpokenLanguage.ENGLISH, text));
        assertEquals(spanish, said(SpokenLanguage.SPANISH, text));
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "Done: #**20. Stopped at 1.200 0.500 m, heading 90.0. | Done stopped at x one meter twenty y fifty centimeters heading ninety",
                "Done: 3 instructions. Stopped at 0.000 0.000 m, heading 359.5. | Done three instructions stopped at x zero meters y zero meters heading three hundred fifty nine point five",
                "Collision after 12 of 20 cm, instruction 1 of 3. | Collision after twelve of twenty centimeters instruction one of three",
                "Infinite loop after 45 of 90 degrees, instruction 1 of 1. | Infinite loop after forty five of ninety degrees instruction one of one",
                "Not a valid command: number expected at key 6. | Not a valid command number expected at key six",
                "Not a valid command: * or # or digit expected at key 4. No key for 10 s. | Not a valid command star or hash or digit expected at key four no key for ten seconds",
                "Not a valid command: digit expected at key 8. Range 1..360 degrees. | Not a valid command digit expected at key eight range one to three hundred sixty degrees",
                "Not a valid command: no process 7 at key 6. Processes: 1-2, 20. | Not a valid command no process seven at key six",
                "Not possible: no motors. | Not possible no motors",
                "Not possible: robot type Foo is not known. Battery low. | Not possible battery low",
                "Started process 1: wander. | Started process one",
                "Stopped by order after 12 of 20 cm | Stopped by order after twelve of twenty centimeters",
                "Executing a command. Moving at 1.000 1.000 m, heading 0.0. | Executing a command moving at x one meter y one meter heading zero",
                "Process wander ended: no way | ''",
            })
    void anEnglishReplyIsReadWithoutKeysAndNames(String reply, String words) {
        assertEquals(words, said(SpokenLanguage.ENGLISH, reply));
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "Hecho: #**20. Parado en 1.200 0.500 m, rumbo 90.0. | Hecho parado en equis un metro veinte i griega cincuenta centímetros rumbo noventa",
                "Hechas 21 instrucciones. En marcha en 0.000 0.000 m, rumbo 0.0. | Hechas veintiuna instrucciones en marcha en equis cero metros i griega cero metros rumbo cero",
                "Choque tras 1 de 20 cm, paso 1 de 3. | Choque tras uno de veinte centímetros paso uno de tres",
                "La orden no vale: se espera * o # o cifra en la tecla 4. Van 10 s sin teclas. | La orden no vale se espera asterisco o almohadilla o cifra en la tecla cuatro van diez segundos sin teclas",
                "La orden no vale: se espera un valor en la tecla 6. Rango 1..9999 cm. | La orden no vale se espera un valor en la tecla seis rango uno a nueve mil novecientos noventa y nueve centímetros",
                "No es posible: sin motores. Queda poca carga. | No es posible sin motores queda poca carga",
                "Ejecutando una orden. | Ejecutando una orden",
                "Iniciado el proceso 2: wall-follow. | Iniciado el proceso dos",
            })
    void aSpanishReplyIsReadWithTheAccentsThatItLacks(String reply, String words) {
        assertEquals(words, said(SpokenLanguage.SPANISH, reply));
    }

    @ParameterizedTest
    @EnumSource(SpokenLanguage.class)
    void everyNumberOfAnOrderHasPrompts(SpokenLanguage language) {
        Set<String> names = Prompts.of(language).names();
        Set<String> used = new TreeSet<>();
        IntStream.rangeClosed(0, 9999)
                .boxed()
                .flatMap(n -> language.amount(n, language.expand("cm")).stream())
                .forEach(used::add);
        used.removeAll(names);
        assertEquals(Set.of(), used);
    }
}
