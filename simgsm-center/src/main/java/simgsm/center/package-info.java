/** M3: the SMS/Phone centre. */
package simgsm.center;
