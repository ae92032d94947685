/** The answers to layer 3 messages that break their standard. */
package simgsm.air.answer;
